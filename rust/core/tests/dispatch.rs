//! Whatever vector instructions a CPU has, effects, gains and whole explorations have the same
//! bits with all of them.

use std::sync::LazyLock;

use crate::oracles::{Stream, fixed};
use crate::runs::LIMIT;
use divbandit_core::coverage::estimate::Estimate;
use divbandit_core::history::Log;
use divbandit_core::strategies::MotorBabbling;
use divbandit_core::trig::sin_cos;
use divbandit_core::{Composition, Exploration, Instructions, PlanarArm};
use proptest::prelude::*;

/// All instructions that this CPU has: none is left out that the standard library finds.
static AVAILABLE: LazyLock<Vec<Instructions>> = LazyLock::new(|| {
    let arm = PlanarArm::new(1, LIMIT).unwrap();
    let found: Vec<Instructions> =
        Instructions::ALL.into_iter().filter(|&each| arm.clone().using(each).is_some()).collect();
    let mut expected = vec![Instructions::Baseline];
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx2") {
            expected.push(Instructions::Avx2);
        }
        if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
            expected.push(Instructions::Avx512);
        }
    }
    println!("instructions tried: {found:?}");
    assert_eq!(found, expected);
    found
});

/// The arm itself, which takes the widest, and one for each of the instructions.
fn arms(joints: usize) -> Vec<PlanarArm> {
    let arm = PlanarArm::new(joints, LIMIT).unwrap();
    let narrower = AVAILABLE.iter().map(|&each| arm.clone().using(each).unwrap());
    std::iter::once(arm.clone()).chain(narrower).collect()
}

/// The base, each joint's far end and the tip, with one sine at a time.
fn plain_posture(command: &[f64]) -> Vec<[f64; 2]> {
    let joints = command.len() as f64;
    let (mut angle, mut x, mut y) = (0.0, 0.0, 0.0);
    let mut points = vec![[0.0, 0.0]];
    for bend in command {
        angle += bend;
        let ([sine], [cosine]) = sin_cos([angle]);
        (x, y) = (x + cosine, y + sine);
        points.push([x / joints, y / joints]);
    }
    points
}

fn bits(points: &[[f64; 2]]) -> Vec<u64> {
    points.as_flattened().iter().map(|x| x.to_bits()).collect()
}

#[test]
fn an_effect_is_the_same_with_all_instructions() {
    for joints in 1..=40 {
        let mut stream = Stream(joints as u64);
        let rows = 1 + stream.below(40);
        let angles: Vec<f64> = (0..rows * joints).map(|_| stream.between(-LIMIT, LIMIT)).collect();
        let postures: Vec<_> = angles.chunks(joints).map(plain_posture).collect();
        let tips: Vec<[f64; 2]> = postures.iter().map(|posture| posture[joints]).collect();
        for arm in arms(joints) {
            let mut together = vec![[f64::NAN; 2]; rows];
            arm.effects(&angles, together.as_flattened_mut()).unwrap();
            assert_eq!(bits(&together), bits(&tips), "{arm:?}");
            for (command, posture) in angles.chunks(joints).zip(&postures) {
                assert_eq!(bits(&[arm.effect(command).unwrap()]), bits(&[posture[joints]]));
                assert_eq!(bits(&arm.posture(command).unwrap()), bits(posture), "{arm:?}");
            }
        }
    }
}

/// ADAPT over motor and goal babbling, as in the paper's figure 4, on this arm.
fn adapt(mut arm: PlanarArm, d: f64) -> Log {
    let mut strategies = Composition::default();
    let parts = vec![strategies.add(MotorBabbling), strategies.add(crate::runs::goal_babbling(d))];
    let root = strategies.compose(crate::runs::adapt(2, 0.02, 50), parts).unwrap();
    let mut history = crate::runs::history(arm.joints(), true, 2);
    let mut run = Exploration::new(strategies, root, &history).unwrap();
    let mut stream = Stream(1);
    run.run(&mut arm, &mut history, 3000, &mut || stream.unit()).unwrap();
    history.into_log().unwrap()
}

#[test]
fn an_exploration_is_the_same_with_all_instructions() {
    for d in [0.001, 0.05, 0.5] {
        let mut logs = arms(20).into_iter().map(|arm| adapt(arm, d));
        let first = logs.next().unwrap();
        assert_eq!(first.effects.len(), 6000);
        assert!(first.paths.contains(&0) && first.paths.contains(&1));
        assert!(logs.all(|log| log == first), "d = {d}");
    }
}

proptest! {
    #![proptest_config(fixed(60))]

    #[test]
    fn an_estimated_gain_is_the_same_with_all_instructions(
        dim in 1..=32_usize, spread in 0.05..1.5_f64, key: u64,
    ) {
        let mut stream = Stream(key);
        let widest = Estimate::new(0.5, dim, 0.003, key);
        let narrower = AVAILABLE.iter().map(|&each| widest.clone().using(each).unwrap());
        let mut unions: Vec<_> = std::iter::once(widest.clone()).chain(narrower).collect();
        for _ in 0..20 {
            let effect: Vec<f64> = (0..dim).map(|_| stream.between(-spread, spread)).collect();
            let mut gains = unions.iter_mut().map(|union| union.insert(&effect)).map(|found| {
                [found.gain, found.standard_error].map(f64::to_bits)
            });
            let first = gains.next().unwrap();
            prop_assert!(gains.all(|gain| gain == first));
        }
    }
}
