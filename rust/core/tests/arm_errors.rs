//! An arm refuses what it cannot bend to, names the argument, and writes nothing.

use divbandit_core::{Error, PlanarArm};

/// The message of a refusal.
fn refused<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn an_arm_needs_joints_and_a_limit() {
    assert_eq!(refused(PlanarArm::new(0, 1.0)), "joints must be from 1 to 100000, got 0");
    for limit in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let expected = format!("limit must be positive and finite (radians), got {limit:?}");
        assert_eq!(refused(PlanarArm::new(3, limit)), expected);
    }
    assert!(PlanarArm::new(4, 2.5e5).is_ok());
    assert!(refused(PlanarArm::new(5, 2.5e5)).starts_with("limit must be at most 1e6"));
}

#[test]
fn a_command_has_one_angle_a_joint_within_the_limit() {
    let arm = PlanarArm::new(3, 2.0).unwrap();
    assert!(arm.effect(&[2.0, -2.0, 0.0]).is_ok(), "the limit itself is allowed");
    let beyond = 2.0_f64.next_up();
    let cases: [(&[f64], &str); 7] = [
        (&[0.0; 2], "command must have length 3, got 2"),
        (&[0.0; 4], "command must have length 3, got 4"),
        (&[], "command must have length 3, got 0"),
        (&[0.0, f64::NAN, 9.0], "command[1] must be finite, got NaN"),
        (&[f64::INFINITY, 0.0, 0.0], "command[0] must be finite, got inf"),
        (&[0.0, f64::NEG_INFINITY, 0.0], "command[1] must be finite, got -inf"),
        (
            &[0.0, 0.0, -beyond],
            "command[2] must be within the joint's limit of +-2.0 radians, \
             got -2.0000000000000004",
        ),
    ];
    for (command, message) in cases {
        assert_eq!(refused(arm.effect(command)), message);
        assert_eq!(refused(arm.posture(command)), message);
    }
}

#[test]
fn a_batch_is_refused_as_a_whole() {
    let arm = PlanarArm::new(3, 2.0).unwrap();
    let good = [0.5; 30];
    let with = |index: usize, angle: f64| {
        let mut commands = good;
        commands[index] = angle;
        commands
    };
    let cases: [(&[f64], usize, &str); 7] = [
        (&good[..29], 20, "commands must be whole rows of 3 numbers, got 29"),
        (&good, 19, "effects must have length 20, got 19"),
        (&good, 22, "effects must have length 20, got 22"),
        (&good, 0, "effects must have length 20, got 0"),
        (&with(29, f64::NAN), 20, "commands[9, 2] must be finite, got NaN"),
        (&with(28, f64::INFINITY), 20, "commands[9, 1] must be finite, got inf"),
        (
            &with(12, 2.5),
            20,
            "commands[4, 0] must be within the joint's limit of +-2.0 radians, got 2.5",
        ),
    ];
    for (commands, room, message) in cases {
        let mut effects = vec![7.25; room];
        assert_eq!(refused(arm.effects(commands, &mut effects)), message);
        assert!(effects.iter().all(|&number| number == 7.25), "{message}: output was touched");
    }
    arm.effects(&[], &mut []).unwrap(); // no commands, no effects
}
