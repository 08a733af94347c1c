//! The arm is a chain of rigid motions, and says so in the same bits however it is asked.

use crate::oracles::{Stream, fixed};
use divbandit_core::PlanarArm;
use nalgebra::{Isometry2, Point2, Translation2, Vector2};
use proptest::prelude::*;

const LIMIT: f64 = 150.0 / 180.0 * std::f64::consts::PI;

/// Angles for `rows` commands; with `extreme`, some joints are bent as far as they go.
fn commands(joints: usize, rows: usize, seed: u64, extreme: bool) -> Vec<f64> {
    let mut stream = Stream(seed);
    let mut angle = || match stream.below(4) {
        0 if extreme => LIMIT,
        1 if extreme => -LIMIT,
        _ => stream.between(-LIMIT, LIMIT),
    };
    (0..joints * rows).map(|_| angle()).collect()
}

/// Turns by each angle in turn, each time going one segment along the new direction.
fn chain(command: &[f64]) -> Point2<f64> {
    let segment = Translation2::new(1.0 / command.len() as f64, 0.0);
    let turn_and_go = |pose: Isometry2<f64>, &angle: &f64| {
        pose * Isometry2::new(Vector2::zeros(), angle) * segment
    };
    command.iter().fold(Isometry2::identity(), turn_and_go) * Point2::origin()
}

proptest! {
    #![proptest_config(fixed(500))]

    #[test]
    fn an_effect_is_the_end_of_a_chain_of_motions(
        joints in 1..=40_usize, seed: u64, extreme: bool,
    ) {
        let arm = PlanarArm::new(joints, LIMIT).unwrap();
        let command = commands(joints, 1, seed, extreme);
        let [x, y] = arm.effect(&command).unwrap();
        let tip = chain(&command);
        prop_assert!((x - tip.x).abs() < 1e-14 && (y - tip.y).abs() < 1e-14, "{x} {y} {tip}");
    }

    #[test]
    fn a_batch_has_the_bits_of_its_samples(
        joints in 1..=40_usize, rows in 1..=40_usize, seed: u64, extreme: bool,
    ) {
        let arm = PlanarArm::new(joints, LIMIT).unwrap();
        let commands = commands(joints, rows, seed, extreme);
        let mut effects = vec![f64::NAN; 2 * rows];
        arm.effects(&commands, &mut effects).unwrap();
        for (command, together) in commands.chunks(joints).zip(effects.chunks(2)) {
            let alone = arm.effect(command).unwrap();
            prop_assert_eq!(alone.map(f64::to_bits), [together[0], together[1]].map(f64::to_bits));
        }
    }

    #[test]
    fn vector_instructions_change_no_bit(joints in 1..=40_usize, seed: u64, extreme: bool) {
        let command = commands(joints, 1, seed, extreme);
        let (mut angle, mut x, mut y) = (0.0, 0.0, 0.0);
        for turn in &command {
            angle += turn;
            // One lane, compiled for any CPU of this kind.
            let ([sine], [cosine]) = divbandit_core::trig::sin_cos([angle]);
            x += cosine;
            y += sine;
        }
        let plain = [x / joints as f64, y / joints as f64];
        let effect = PlanarArm::new(joints, LIMIT).unwrap().effect(&command).unwrap();
        prop_assert_eq!(effect.map(f64::to_bits), plain.map(f64::to_bits));
    }

    #[test]
    fn a_posture_leads_from_the_base_to_the_effect(
        joints in 1..=40_usize, seed: u64, extreme: bool,
    ) {
        let arm = PlanarArm::new(joints, LIMIT).unwrap();
        let command = commands(joints, 1, seed, extreme);
        let posture = arm.posture(&command).unwrap();
        prop_assert_eq!(posture.len(), joints + 1);
        prop_assert_eq!(posture[0], [0.0, 0.0]);
        let tip = arm.effect(&command).unwrap();
        prop_assert_eq!(posture[joints].map(f64::to_bits), tip.map(f64::to_bits));
        for ends in posture.windows(2) {
            let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
            prop_assert!((length - 1.0 / joints as f64).abs() < 1e-15, "{length}");
        }
    }
}

#[test]
fn a_straight_arm_lies_along_x_and_a_quarter_turn_puts_it_along_y() {
    for joints in 1..=40 {
        let arm = PlanarArm::new(joints, LIMIT).unwrap();
        let mut command = vec![0.0; joints];
        assert_eq!(arm.effect(&command).unwrap(), [1.0, 0.0]);
        command[0] = std::f64::consts::FRAC_PI_2;
        let [x, y] = arm.effect(&command).unwrap();
        assert!(x.abs() < 1e-16 && (y - 1.0).abs() < 1e-15, "{joints}: {x} {y}");
    }
}
