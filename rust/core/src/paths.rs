//! Paths: who proposed each command, from the outermost strategy to the innermost.
//!
//! A path is a branch of the tree of all choices made so far: a step logs one number, the branch's
//! end.

/// The branches taken so far.
#[derive(Debug, Clone)]
pub struct Paths {
    nodes: Vec<Node>,
}

/// The end of a path.
#[derive(Debug, Clone)]
struct Node {
    /// The node before it, and the index that was chosen there.
    parent: u32,
    index: u32,
    depth: u32,
    /// The indices chosen from here so far, each with its node.
    children: Vec<(u32, u32)>,
}

/// The empty path, that of a strategy which explores alone.
pub const ROOT: u32 = 0;

impl Default for Paths {
    /// The empty path alone.
    fn default() -> Self {
        Self { nodes: vec![Node { parent: ROOT, index: 0, depth: 0, children: vec![] }] }
    }
}

impl Paths {
    /// The path to `node`, continued by the choice of part `index`.
    pub fn child(&mut self, node: u32, index: u32) -> u32 {
        let parent = &self.nodes[node as usize];
        if let Some(&(_, child)) = parent.children.iter().find(|&&(known, _)| known == index) {
            return child;
        }
        let (child, depth) = (self.nodes.len() as u32, parent.depth + 1);
        self.nodes[node as usize].children.push((index, child));
        self.nodes.push(Node { parent: node, index, depth, children: vec![] });
        child
    }

    /// The path of these indices, outermost first.
    pub fn of(&mut self, path: &[u32]) -> u32 {
        path.iter().fold(ROOT, |node, &index| self.child(node, index))
    }

    /// The length of the path to `node`.
    #[must_use]
    pub fn length(&self, node: u32) -> usize {
        self.nodes[node as usize].depth as usize
    }

    /// Writes the path that ends at `node` to a row: indices of strategies, outermost first, -1
    /// beyond the innermost.
    ///
    /// # Panics
    /// If the row is shorter than the path.
    pub fn write(&self, mut node: u32, row: &mut [i64]) {
        row.fill(-1);
        while node != ROOT {
            let Node { parent, index, depth, .. } = self.nodes[node as usize];
            row[depth as usize - 1] = i64::from(index);
            node = parent;
        }
    }
}
