//! The hard maze of novelty search: a small network drives a robot for 400 steps.
//!
//! Lehman and Stanley (2011) let NEAT grow the network. Here its shape is fixed and a command holds its
//! weights; walls, sensors and the rules of motion are theirs. The effect is where the robot ends.
//!
//! Rays and distances are parry's: for segments of f64 both are additions, multiplications, divisions
//! and square roots in a fixed order.

use std::f64::consts::PI;

use parry2d_f64::math::Vector;
use parry2d_f64::query::{PointQuery, Ray, RayCast};
use parry2d_f64::shape::Segment;

use crate::elementary::exp;
use crate::environment::Environment;
use crate::error::{Error, check_each, check_finite, check_length};
use crate::trig::sin_cos;

/// The ends of each wall.
const WALLS: [[[f64; 2]; 2]; 13] = [
    [[41.0, 5.0], [3.0, 8.0]],
    [[3.0, 8.0], [4.0, 49.0]],
    [[4.0, 49.0], [57.0, 53.0]],
    [[4.0, 49.0], [7.0, 202.0]],
    [[7.0, 202.0], [195.0, 198.0]],
    [[195.0, 198.0], [186.0, 8.0]],
    [[186.0, 8.0], [39.0, 5.0]],
    [[56.0, 54.0], [56.0, 157.0]],
    [[57.0, 106.0], [158.0, 162.0]],
    [[77.0, 201.0], [108.0, 164.0]],
    [[6.0, 80.0], [33.0, 121.0]],
    [[192.0, 146.0], [87.0, 91.0]],
    [[56.0, 55.0], [133.0, 30.0]],
];
const START: Vector = Vector::new(36.0, 184.0);
const GOAL: Vector = Vector::new(31.0, 20.0);

/// Closer to the goal than this, the robot stays.
const AT_GOAL: f64 = 5.0;

const STEPS: usize = 400;
const RADIUS: f64 = 8.0;

/// The most that it moves and turns in a step, in units of length and in degrees.
const FASTEST: f64 = 3.0;

/// Where the range finders look, in degrees from the heading.
const LOOKS: [f64; 6] = [-90.0, -45.0, 0.0, 45.0, 90.0, -180.0];

/// Which of them looks ahead.
const AHEAD: usize = 2;
const RANGE: f64 = 100.0;
const DEGREE: f64 = PI / 180.0;

/// A bias, the range finders and the slices of the compass.
const SENSES: usize = 1 + LOOKS.len() + 4;
const HIDDEN: usize = 5;

/// The weights of the hidden units, unit by unit; then those of both outputs, each with its bias first.
const WEIGHTS: usize = HIDDEN * SENSES + 2 * (1 + HIDDEN);

/// Weights lie in [-LIMIT, LIMIT].
const LIMIT: f64 = 3.0;

/// How steep NEAT's logistic function is.
const SLOPE: f64 = 4.924_273;

/// The hard maze.
#[derive(Debug, Clone)]
pub struct Maze {
    walls: [Segment; WALLS.len()],
}

impl Maze {
    /// How many weights a command holds.
    pub const WEIGHTS: usize = WEIGHTS;

    /// Their limit, up or down.
    pub const LIMIT: f64 = LIMIT;

    /// The ends of each wall.
    pub const WALLS: [[[f64; 2]; 2]; 13] = WALLS;

    /// Where it would best end.
    pub const GOAL: [f64; 2] = [GOAL.x, GOAL.y];

    /// The maze; there is only one.
    #[must_use]
    pub fn new() -> Self {
        Self { walls: WALLS.map(|[a, b]| Segment::new(a.into(), b.into())) }
    }

    /// Where the robot ends with these weights.
    ///
    /// ```
    /// use divbandit_core::Maze;
    ///
    /// // Both outputs are 1/2: it stays.
    /// assert_eq!(Maze::new().effect(&[0.0; Maze::WEIGHTS]), Ok([36.0, 184.0]));
    /// ```
    ///
    /// # Errors
    /// If there are not [`WEIGHTS`](Self::WEIGHTS) of them, or one is not finite or beyond the limit.
    pub fn effect(&self, command: &[f64]) -> Result<[f64; 2], Error> {
        self.run(command, |_| ())
    }

    /// Where the robot starts and where it is after each step, until it is at the goal.
    ///
    /// # Errors
    /// As [`effect`](Self::effect).
    pub fn path(&self, command: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        let mut path = Vec::with_capacity(1 + STEPS);
        self.run(command, |place| path.push(place.into()))?;
        Ok(path)
    }

    /// Checks weights, those of one command or of many; a NaN is refused as well.
    ///
    /// # Errors
    /// Naming the first that is not finite or beyond the limit.
    pub fn check(&self, commands: &[f64]) -> Result<(), Error> {
        let name = "command";
        check_finite(name, commands, WEIGHTS)?;
        let must_be = format_args!("a weight in [-{LIMIT:?}, {LIMIT:?}]");
        check_each(name, commands, WEIGHTS, must_be, |weight| weight.abs() <= LIMIT)
    }

    fn run(&self, command: &[f64], mut look: impl FnMut(Vector)) -> Result<[f64; 2], Error> {
        check_length("command", command, WEIGHTS)?;
        self.check(command)?;
        let mut robot = Robot { place: START, heading: 0.0, speed: 0.0, turn: 0.0 };
        look(robot.place);
        for _ in 0..STEPS {
            robot.step(self, command);
            look(robot.place);
            if robot.place.distance(GOAL) < AT_GOAL {
                break;
            }
        }
        Ok(robot.place.into())
    }

    /// How far one sees from a place in a direction of length 1.
    fn range(&self, place: Vector, direction: Vector) -> f64 {
        let ray = Ray::new(place, direction);
        // Most walls lie to one side of a ray, or behind it: it costs less to see that than to cast.
        let may_be_seen = |wall: &&Segment| {
            let (a, b) = (wall.a - place, wall.b - place);
            direction.perp_dot(a) * direction.perp_dot(b) <= 0.0
                && (direction.dot(a) >= 0.0 || direction.dot(b) >= 0.0)
        };
        let seen = |range, wall: &Segment| wall.cast_local_ray(&ray, range, true).unwrap_or(range);
        self.walls.iter().filter(may_be_seen).fold(RANGE, seen)
    }

    /// Whether the robot can be there.
    fn is_free(&self, place: Vector) -> bool {
        self.walls.iter().all(|wall| wall.distance_to_local_point(place, true) >= RADIUS)
    }
}

impl Default for Maze {
    fn default() -> Self {
        Self::new()
    }
}

impl Environment for Maze {
    fn motor_dim(&self) -> usize {
        WEIGHTS
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&self.effect(command)?);
        Ok(())
    }
}

/// The robot on its way.
struct Robot {
    place: Vector,
    /// In degrees, from 0 to 360.
    heading: f64,
    speed: f64,
    /// In degrees a step.
    turn: f64,
}

impl Robot {
    fn step(&mut self, maze: &Maze, weights: &[f64]) {
        let (sines, cosines) = sin_cos(LOOKS.map(|look| (self.heading + look) * DEGREE));
        let directions: [Vector; LOOKS.len()] =
            std::array::from_fn(|look| Vector::new(cosines[look], sines[look]));

        let [turn, speed] = outputs(weights, &self.senses(maze, &directions));
        self.turn = (self.turn + (turn - 0.5)).clamp(-FASTEST, FASTEST);
        self.speed = (self.speed + (speed - 0.5)).clamp(-FASTEST, FASTEST);

        // It moves where it headed before it turns.
        let place = self.place + directions[AHEAD] * self.speed;
        self.heading += self.turn;
        if self.heading > 360.0 {
            self.heading -= 360.0;
        }
        if self.heading < 0.0 {
            self.heading += 360.0;
        }
        if maze.is_free(place) {
            self.place = place;
        }
    }

    fn senses(&self, maze: &Maze, directions: &[Vector; LOOKS.len()]) -> [f64; SENSES] {
        let mut senses = [1.0; SENSES];
        let (ranges, slices) = senses[1..].split_at_mut(LOOKS.len());
        for (range, &direction) in ranges.iter_mut().zip(directions) {
            *range = maze.range(self.place, direction) / RANGE;
        }
        let (to_goal, ahead) = (GOAL - self.place, directions[AHEAD]);
        let forth = ahead.x * to_goal.x + ahead.y * to_goal.y;
        let aside = ahead.x * to_goal.y - ahead.y * to_goal.x;
        slices.copy_from_slice(&compass(forth, aside));
        senses
    }
}

/// In which quarter something is: ahead, at +90 degrees, behind, at -90 degrees. Each begins at its lower
/// angle.
fn compass(forth: f64, aside: f64) -> [f64; 4] {
    [
        aside >= -forth && aside < forth,
        aside >= forth && aside > -forth,
        aside <= -forth && aside > forth,
        aside <= forth && aside < -forth,
    ]
    .map(f64::from)
}

/// The network.
fn outputs(weights: &[f64], senses: &[f64; SENSES]) -> [f64; 2] {
    let (hidden, output) = weights.split_at(HIDDEN * SENSES);
    let mut units = [1.0; 1 + HIDDEN];
    for (unit, weights) in units[1..].iter_mut().zip(hidden.chunks_exact(SENSES)) {
        *unit = logistic(weights, senses);
    }
    let (turn, speed) = output.split_at(1 + HIDDEN);
    [logistic(turn, &units), logistic(speed, &units)]
}

fn logistic(weights: &[f64], inputs: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (weight, input) in weights.iter().zip(inputs) {
        sum += weight * input;
    }
    1.0 / (1.0 + exp(-SLOPE * sum))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_begins_at_its_lower_angle() {
        let sides = [-1.0, 0.0, 1.0];
        let at = |aside: f64| sides.map(|forth| compass(forth, aside));
        let [ahead, plus, behind, minus] =
            [0, 1, 2, 3].map(|one| std::array::from_fn(|each| f64::from(each == one)));
        assert_eq!(at(-1.0), [minus, minus, ahead]);
        assert_eq!(at(0.0), [behind, [0.0; 4], ahead]);
        assert_eq!(at(1.0), [behind, plus, plus]);
    }

    #[test]
    fn one_sees_the_nearest_wall_but_not_farther_than_the_range() {
        let maze = Maze::new();
        let up = Vector::new(0.0, -1.0);
        let wall = 106.0 + 56.0 * (150.0 - 57.0) / 101.0;
        let range = maze.range(Vector::new(150.0, 180.0), up);
        assert!((range - (180.0 - wall)).abs() < 1e-12, "{range}");
        assert_eq!(maze.range(Vector::new(45.0, 190.0), up), RANGE);
    }

    #[test]
    fn the_robot_touches_no_wall_at_the_start() {
        assert!(Maze::new().is_free(START));
        assert!(!Maze::new().is_free(Vector::new(64.0 - 1e-9, 100.0)));
        assert!(Maze::new().is_free(Vector::new(48.0, 120.0)));
    }
}
