//! First contact against brute force: ten thousand small steps, with parry's own queries for whole shapes.

use crate::oracles::Stream;
use divbandit_core::{Error, Obstacle, ObstructedArm, PlanarArm};
use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::{distance, intersection_test};
use parry2d_f64::shape::{Ball, Capsule, ConvexPolygon, Shape};

const STEPS: usize = 10_000;

/// A shape as the kernel and as parry know it.
struct Thing {
    obstacle: Obstacle,
    shape: Box<dyn Shape>,
    at: Vector,
}

fn thing(stream: &mut Stream) -> Thing {
    let at = [stream.between(-1.0, 1.0), stream.between(-1.0, 1.0)];
    let size = stream.between(0.01, 0.2);
    let (obstacle, shape): (Obstacle, Box<dyn Shape>) = match stream.below(3) {
        0 => (Obstacle::disc(at, size).unwrap(), Box::new(Ball::new(size))),
        1 => {
            let turn = stream.between(0.0, 6.0);
            let corner = |k: usize| {
                let (sine, cosine) = (turn + std::f64::consts::TAU / 5.0 * k as f64).sin_cos();
                [size * cosine, size * sine]
            };
            let corners: Vec<[f64; 2]> = (0..5).map(corner).collect();
            let placed: Vec<[f64; 2]> =
                corners.iter().map(|[x, y]| [at[0] + x, at[1] + y]).collect();
            let hull: Vec<Vector> = corners.into_iter().map(Vector::from).collect();
            let shape = ConvexPolygon::from_convex_polyline(hull).unwrap();
            (Obstacle::polygon(&placed).unwrap(), Box::new(shape))
        }
        _ => {
            let thickness = [1e-6, 1e-3, 0.05][stream.below(3)];
            let end = [size * stream.between(-1.0, 1.0), size];
            let wall = Obstacle::wall(at, [at[0] + end[0], at[1] + end[1]], thickness).unwrap();
            (wall, Box::new(Capsule::new(Vector::ZERO, Vector::from(end), thickness / 2.0)))
        }
    };
    Thing { obstacle, shape, at: Vector::from(at) }
}

/// The least distance between the arm in this posture and a thing; 0 or less where they meet.
fn clearance(posture: &[[f64; 2]], radius: f64, things: &[Thing]) -> f64 {
    let mut least = f64::INFINITY;
    for ends in posture.windows(2) {
        let link = Capsule::new(Vector::from(ends[0]), Vector::from(ends[1]), radius);
        for thing in things {
            let place = Pose::translation(thing.at.x, thing.at.y);
            let here = Pose::IDENTITY;
            if intersection_test(&here, &link, &place, &*thing.shape).unwrap().intersecting {
                return 0.0;
            }
            least = least.min(distance(&here, &link, &place, &*thing.shape).unwrap().distance);
        }
    }
    least
}

fn scaled(command: &[f64], share: f64) -> Vec<f64> {
    command.iter().map(|angle| share * angle).collect()
}

#[test]
fn random_scenes_against_small_steps() {
    let mut stream = Stream(6);
    let (mut compared, mut stopped) = (0, 0);
    while compared < 60 {
        let joints = 1 + stream.below(8);
        let free = PlanarArm::new(joints, 2.6).unwrap();
        let thickness = stream.between(0.001, 0.05);
        let things: Vec<Thing> = (0..1 + stream.below(4)).map(|_| thing(&mut stream)).collect();
        let obstacles = things.iter().map(|thing| thing.obstacle.clone()).collect();
        let Ok(arm) = ObstructedArm::new(free.clone(), thickness, obstacles, false) else {
            continue;
        };
        let command: Vec<f64> = (0..joints).map(|_| stream.between(-2.6, 2.6)).collect();
        let share = arm.moving().progress(&command).unwrap();
        let clear = |share: f64| {
            let posture = free.posture(&scaled(&command, share)).unwrap();
            clearance(&posture, thickness / 2.0, &things)
        };
        // All steps before the stop are clear, up to what a step can touch and leave again.
        let first = (0..=STEPS).map(|k| k as f64 / STEPS as f64).find(|&step| clear(step) <= 0.0);
        if share < 1.0 {
            stopped += 1;
            assert!(first.is_none_or(|first| first > share), "{share} {first:?}");
            let left = clear(share);
            // parry's general queries are right to some 1e-7 of small shapes.
            assert!((0.0..=1e-6).contains(&left), "{left}");
        } else {
            assert_eq!(first, None);
        }
        compared += 1;
    }
    assert!((15..=45).contains(&stopped), "{stopped} of {compared} stopped");
}

/// One link, as long as 1 and 0.1 thick, sweeps against a disc: contact where its side is as far away as the radii.
#[test]
fn a_link_stops_at_a_disc() {
    for (distance, radius) in [(0.5, 0.1), (0.9, 0.3), (0.2, 0.01)] {
        let disc = Obstacle::disc([0.0, distance], radius).unwrap();
        let free = PlanarArm::new(1, 2.0).unwrap();
        let arm = ObstructedArm::new(free, 0.1, vec![disc], false).unwrap();
        let angle = std::f64::consts::FRAC_PI_2 - ((radius + 0.05) / distance).asin();
        for command in [2.0, 1.7] {
            let share = arm.moving().progress(&[command]).unwrap();
            assert!((share - angle / command).abs() <= 1e-9, "{share}");
        }
        assert_eq!(arm.moving().progress(&[-2.0]), Ok(1.0));
    }
}

/// Walls of hardly any thickness are not passed, however fast the tip is.
#[test]
fn no_wall_is_too_thin() {
    for thickness in [0.0, 1e-12, 1e-6] {
        let wall = Obstacle::wall([-0.02, 0.9], [0.02, 0.9], thickness).unwrap();
        let free = PlanarArm::new(20, 2.6).unwrap();
        let arm = ObstructedArm::new(free, 1e-6, vec![wall], false).unwrap();
        let mut command = [0.0; 20];
        command[0] = 2.6; // the straight arm goes round: its side meets the wall's right end
        let share = arm.moving().progress(&command).unwrap();
        let angle =
            (0.9_f64 / 0.02).atan() - ((1e-6 + thickness) / 2.0 / 0.9_f64.hypot(0.02)).asin();
        assert!((share * 2.6 - angle).abs() < 2.6e-9, "{share}");
    }
}

/// Three links fold to a triangle of equal sides less what they are thick.
#[test]
fn links_stop_each_other() {
    let free = PlanarArm::new(3, 2.6).unwrap();
    let arm = ObstructedArm::new(free, 0.02, Vec::new(), true).unwrap();
    let command = [0.0, 2.0, 2.6];
    let share = arm.moving().progress(&command).unwrap();
    let points = arm.moving().posture(&command).unwrap();
    // The tip comes down on the first link, as soon as it is no higher than both are thick.
    let (mut above, mut below) = (0.8, 0.97);
    for _ in 0..60 {
        let share: f64 = 0.5 * (above + below);
        let height = ((2.0 * share).sin() + (4.6 * share).sin()) / 3.0;
        *(if height > 0.02 { &mut above } else { &mut below }) = share;
    }
    assert!((share - above).abs() <= 1e-9, "{share} {above}");
    assert!(points[3][0] > 0.05 && (points[3][1] - 0.02).abs() < 1e-8, "{points:?}");
    let passing = ObstructedArm::new(PlanarArm::new(3, 2.6).unwrap(), 0.02, Vec::new(), false);
    assert_eq!(passing.unwrap().moving().progress(&command), Ok(1.0));
}

/// Obstacles out of reach change no bit, and neither does the order of those within.
#[test]
fn the_order_of_obstacles_does_not_matter() {
    let mut stream = Stream(7);
    let free = PlanarArm::new(12, 2.6).unwrap();
    let mut things: Vec<Obstacle> = Vec::new();
    while things.len() < 40 {
        let one = thing(&mut stream).obstacle;
        if ObstructedArm::new(free.clone(), 0.01, vec![one.clone()], false).is_ok() {
            things.push(one);
        }
    }
    let one = ObstructedArm::new(free.clone(), 0.01, things.clone(), false).unwrap();
    stream.shuffle(&mut things);
    things.push(Obstacle::disc([5.0, 5.0], 1.0).unwrap());
    let other = ObstructedArm::new(free.clone(), 0.01, things, false).unwrap();
    let (mut here, mut there) = (one.moving(), other.moving());
    for _ in 0..200 {
        let command: Vec<f64> = (0..12).map(|_| stream.between(-2.6, 2.6)).collect();
        let share = here.progress(&command).unwrap();
        assert_eq!(share.to_bits(), there.progress(&command).unwrap().to_bits());
        let effect = here.effect(&command).unwrap();
        let posture = free.effect(&scaled(&command, share)).unwrap();
        assert_eq!(effect.map(f64::to_bits), posture.map(f64::to_bits));
    }
}

/// Many obstacles in one place give boxes that cannot be told apart.
#[test]
fn a_thousand_times_the_same_obstacle() {
    let disc = Obstacle::disc([0.3, 0.6], 0.1).unwrap();
    let free = PlanarArm::new(2, 2.6).unwrap();
    let once = ObstructedArm::new(free.clone(), 0.01, vec![disc.clone()], false).unwrap();
    let often = ObstructedArm::new(free, 0.01, vec![disc; 1000], false).unwrap();
    let command = [2.0, 0.3];
    assert_eq!(once.moving().effect(&command), often.moving().effect(&command));
}

#[test]
fn a_trajectory_goes_round_what_the_straight_line_meets() {
    let wall = Obstacle::wall([0.9, 0.5], [0.6, 0.5], 0.0).unwrap();
    let arm = PlanarArm::new(2, 2.6).unwrap();
    let arm = ObstructedArm::new(arm, 0.01, vec![wall], false).unwrap();
    let target = [0.9, 0.3];
    assert!(arm.moving().progress(&target).unwrap() < 1.0);
    let round = [0.0, 0.0, 0.0, 2.0, 1.2, 2.0, 1.2, 0.3];
    let free = arm.free().effect(&[1.2, 0.3]).unwrap();
    assert_eq!(arm.moving().follow(&round).unwrap(), free);
    let straight = [0.0, 0.0, 0.9, 0.3];
    assert_eq!(arm.moving().follow(&straight), arm.moving().effect(&target));
    // What stopped it once stops it for good.
    let on = [0.0, 0.0, 0.9, 0.3, 0.0, 0.0];
    assert_eq!(arm.moving().follow(&on), arm.moving().effect(&target));
}

#[test]
fn what_is_refused() {
    let arm = || PlanarArm::new(4, 2.6).unwrap();
    let refused = |thickness, obstacles| {
        ObstructedArm::new(arm(), thickness, obstacles, false).unwrap_err().to_string()
    };
    for thickness in [0.0, -0.1, 1e-7, 0.25, f64::NAN, f64::INFINITY] {
        assert!(refused(thickness, vec![]).starts_with("thickness must be at least 1e-6"));
    }
    let away = Obstacle::disc([0.0, 0.5], 0.1).unwrap();
    let around = [[-1.0, -1.0], [2.0, -1.0], [2.0, 1.0], [-1.0, 1.0]];
    for on in [
        Obstacle::disc([0.6, 0.1], 0.0951).unwrap(),
        Obstacle::polygon(&around).unwrap(),
        Obstacle::wall([0.6, -0.5], [0.6, 0.5], 0.0).unwrap(),
        Obstacle::rectangle([-0.1, -0.1], [0.1, 0.1]).unwrap(),
    ] {
        let message = refused(0.01, vec![away.clone(), on]);
        assert!(message.starts_with("obstacles[1] must be clear of the arm at rest"), "{message}");
    }
    let just_clear = Obstacle::disc([0.6, 0.1], 0.0949).unwrap();
    let arm = ObstructedArm::new(arm(), 0.01, vec![just_clear], false).unwrap();
    let mut moving = arm.moving();
    assert_eq!(moving.follow(&[]), Err(Error::Empty { name: "trajectory" }));
    assert!(moving.follow(&[0.0; 6]).is_err());
    assert!(
        moving.follow(&[0.1; 8]).unwrap_err().to_string().starts_with("trajectory[0, 0] must be 0")
    );
    assert!(moving.effect(&[0.0; 3]).is_err() && moving.effect(&[f64::NAN; 4]).is_err());

    let shape = |points: &[[f64; 2]]| Obstacle::polygon(points).unwrap_err().to_string();
    assert!(shape(&[[0.0, 0.0], [1.0, 0.0]]).starts_with("points must be from 3 to 10000 corners"));
    for points in [
        vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]],
        vec![[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        vec![[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]],
        vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]],
    ] {
        assert!(shape(&points).contains("an outline that does not touch itself"), "{points:?}");
    }
    assert!(
        Obstacle::disc([0.0, f64::NAN], 1.0).is_err() && Obstacle::disc([0.0, 1e7], 1.0).is_err()
    );
    assert!(
        Obstacle::disc([0.0, 0.0], 0.0).is_err() && Obstacle::disc([0.0, 0.0], f64::NAN).is_err()
    );
    assert!(Obstacle::wall([0.0, 0.0], [0.0, 0.0], 0.1).is_err());
    assert!(Obstacle::wall([0.0, 0.0], [1.0, 0.0], -0.1).is_err());
    assert!(Obstacle::rectangle([0.0, 0.0], [1.0, 0.0]).is_err());
}
