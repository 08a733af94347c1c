//! Paths: who proposed each command, from the outermost strategy to the innermost.
//!
//! A path is a branch of the tree of all choices that can be made. Branches grow when they are
//! first taken; a step of the log is then a single number, its branch's end.

/// The branches taken so far.
#[derive(Debug)]
pub(super) struct Paths {
    nodes: Vec<Node>,
}

/// A strategy in its place: the same one may be a part of several others.
#[derive(Debug)]
struct Node {
    /// Which part of the composition it is.
    part: usize,
    /// The node of the strategy that it is a part of, and its index there.
    parent: u32,
    index: u32,
    depth: u32,
    /// The nodes of its own parts, those not yet chosen being [`NONE`].
    children: Vec<u32>,
}

/// The outermost strategy, a part of none.
pub(super) const ROOT: u32 = 0;

const NONE: u32 = u32::MAX;

impl Paths {
    /// No branches yet from the part `root`.
    pub fn new(root: usize) -> Self {
        Self {
            nodes: vec![Node { part: root, parent: NONE, index: 0, depth: 0, children: vec![] }],
        }
    }

    /// Which part of the composition stands at `node`.
    pub fn part(&self, node: u32) -> usize {
        self.nodes[node as usize].part
    }

    /// The node of part `index` of the composite at `node`, whose parts are `parts`.
    pub fn child(&mut self, node: u32, index: usize, parts: &[usize]) -> u32 {
        let next = self.nodes.len() as u32;
        let parent = &mut self.nodes[node as usize];
        parent.children.resize(parts.len(), NONE);
        let child = &mut parent.children[index];
        if *child != NONE {
            return *child;
        }
        *child = next;
        let depth = parent.depth + 1;
        let (part, index) = (parts[index], index as u32);
        self.nodes.push(Node { part, parent: node, index, depth, children: vec![] });
        next
    }

    /// The node of the composite that `node` is a part of, and its index there; None at the root.
    pub fn parent(&self, node: u32) -> Option<(u32, usize)> {
        let Node { parent, index, .. } = self.nodes[node as usize];
        (parent != NONE).then_some((parent, index as usize))
    }

    /// The length of the longest path.
    pub fn depth(&self) -> usize {
        self.nodes.iter().map(|node| node.depth as usize).max().unwrap_or(0)
    }

    /// The path that ends at `node`, written to a row: indices of strategies, outermost first, -1
    /// beyond the innermost.
    pub fn write(&self, mut node: u32, row: &mut [i64]) {
        row.fill(-1);
        while let Some((parent, index)) = self.parent(node) {
            row[self.nodes[parent as usize].depth as usize] = index as i64;
            node = parent;
        }
    }
}
