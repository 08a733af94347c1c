//! Ties: which are the best, where several are.

/// Writes where the largest values are: at least one place, if there are values.
pub(super) fn best(values: &[f64], places: &mut Vec<usize>) {
    places.clear();
    let mut largest = f64::NEG_INFINITY;
    for (place, &value) in values.iter().enumerate() {
        if places.is_empty() || value > largest {
            places.clear();
            places.push(place);
            largest = value;
        } else if value == largest {
            places.push(place);
        }
    }
}

/// One of these places, uniformly at random.
pub(super) fn one_of(places: &[usize], u: f64) -> usize {
    places[(u * places.len() as f64) as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_the_largest() {
        let mut places = Vec::new();
        best(&[1.0, 3.0, 2.0, 3.0], &mut places);
        assert_eq!(places, [1, 3]);
        assert_eq!([one_of(&places, 0.49), one_of(&places, 0.5)], [1, 3]);
        best(&[f64::NEG_INFINITY; 2], &mut places);
        assert_eq!(places, [0, 1]);
    }

    #[test]
    fn there_is_always_a_best_one() {
        let mut places = Vec::new();
        best(&[f64::NAN, f64::NAN], &mut places);
        assert_eq!(places, [0]);
    }
}
