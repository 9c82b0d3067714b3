//! A batch gives every row the same bits as alone, and rejects the same rows.

use jointproof::catalog::{AnyFormula, CATALOG, find};
use jointproof::connector::slot::ContactForce;
use jointproof::formula::Field;
use jointproof::toolkit::batch::{ArrayView1, ArrayViewMut1, Error, Part, RowError, value, value_and_jacobian};
use jointproof::toolkit::measure::Options;
use jointproof::toolkit::verify::golden::{File, components};
use ndarray::{Array2, Axis, arr0};

/// Numbers that many formulas reject, or that differ greatly from those of other rows.
const ODD: [f64; 9] = [f64::NAN, f64::INFINITY, -1.0, 0.0, -0.0, 1e200, -1e-200, 5e-324, f64::MAX];

fn components_of(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

/// Golden points including invalid ones, then random ones, `odd` of which contain an odd number.
fn points(formula: &dyn AnyFormula, random: usize, odd: usize) -> Array2<f64> {
    let path = format!("{}/golden/{}.json", env!("CARGO_MANIFEST_DIR"), formula.spec().id);
    let cases = File::parse(&std::fs::read_to_string(path).unwrap()).unwrap().cases;
    let golden = cases.iter().filter_map(|case| components(formula.inputs(), &case.inputs).ok()).flatten();
    let random = formula.timing_inputs(&Options { timing_points: random, ..Options::quick() });
    let numbers: Vec<_> = golden.chain(random).collect();
    let len = components_of(formula.inputs());
    let mut points = Array2::from_shape_vec((numbers.len() / len, len), numbers).unwrap();
    let rows = points.nrows();
    for k in 0..odd {
        points[[rows - 1 - 2 * k, k % len]] = ODD[k % ODD.len()];
    }
    points
}

/// The results of a row alone: the value, and the entries that are not zero everywhere.
fn alone(formula: &dyn AnyFormula, point: &[f64]) -> Result<Vec<f64>, jointproof::Error> {
    let (mut numbers, mut jacobian) = formula.value_and_jacobian(point)?;
    let taken = |[output, input]: [usize; 2]| std::mem::take(&mut jacobian[output * point.len() + input]);
    numbers.extend(formula.batch_entries().into_iter().map(taken));
    assert_eq!(bits(&jacobian), vec![0; jacobian.len()], "{}: {point:?}", formula.spec().id);
    Ok(numbers)
}

fn columns(table: &Array2<f64>) -> Vec<ArrayView1<'_, f64>> {
    table.columns().into_iter().collect()
}

fn columns_mut(table: &mut Array2<f64>) -> Vec<ArrayViewMut1<'_, f64>> {
    table.columns_mut().into_iter().collect()
}

fn bits<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    // NaN has many bits.
    numbers.into_iter().map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() }).collect()
}

/// The error that a batch must report for rows with these results.
fn refused<T>(rows: &[Result<T, jointproof::Error>]) -> Option<Error> {
    let wrong = rows.iter().enumerate().filter_map(|(row, result)| Some((row, result.as_ref().err()?.clone())));
    let count = wrong.clone().count();
    wrong.map(|(row, error)| Error::Rows { first: RowError { row, error }, count }).next()
}

fn assert_rows(id: &str, points: &Array2<f64>, found: &Array2<f64>, expected: &[Result<Vec<f64>, jointproof::Error>]) {
    for ((point, found), expected) in points.rows().into_iter().zip(found.rows()).zip(expected) {
        let nan = vec![f64::NAN; found.len()];
        assert_eq!(bits(found), bits(expected.as_ref().unwrap_or(&nan)), "{id}: {point}");
    }
}

/// The same points evaluated as rows of a table, as its columns, and one by one.
fn compare(formula: &dyn AnyFormula, points: &Array2<f64>) {
    let (id, outputs) = (formula.spec().id, components_of(formula.outputs()));
    let expected: Vec<_> = points.rows().into_iter().map(|point| alone(formula, point.as_slice().unwrap())).collect();
    let shape = (points.nrows(), outputs + formula.batch_entries().len());
    let in_pieces = Array2::from_shape_vec(points.raw_dim(), points.iter().copied().collect()).unwrap();
    let by_columns = points.t().as_standard_layout().reversed_axes().to_owned();
    for (inputs, mut results) in
        [(in_pieces, Array2::zeros(shape)), (by_columns, Array2::zeros([shape.1, shape.0]).reversed_axes())]
    {
        let (mut value, mut jacobian) = results.view_mut().split_at(Axis(1), outputs);
        let [value, jacobian] =
            [&mut value, &mut jacobian].map(|table| table.columns_mut().into_iter().collect::<Vec<_>>());
        let found = formula.batch_value_and_jacobian(&columns(&inputs), &mut { value }, &mut { jacobian });
        // NaN is not equal to itself.
        assert_eq!(format!("{:?}", found.err()), format!("{:?}", refused(&expected)), "{id}");
        assert_rows(id, points, &results, &expected);
    }
    let expected: Vec<_> = points.rows().into_iter().map(|point| formula.value(point.as_slice().unwrap())).collect();
    let mut values = Array2::zeros((points.nrows(), outputs));
    let found = formula.batch_value(&columns(points), &mut columns_mut(&mut values));
    assert_eq!(format!("{:?}", found.err()), format!("{:?}", refused(&expected)), "{id}");
    assert_rows(id, points, &values, &expected);
}

#[test]
fn every_row_has_its_own_bits() {
    for formula in CATALOG {
        compare(*formula, &points(*formula, 60, 18));
        compare(*formula, &points(*formula, 45, 0));
    }
}

/// As many as are computed together, fewer and more, in columns that begin anywhere in a cache line.
#[test]
fn every_row_has_its_own_bits_in_batches_of_any_length() {
    let formula = find("slot.friction").unwrap();
    let points = points(formula, 80, 0);
    let by_columns = points.t().as_standard_layout().reversed_axes().to_owned();
    let expected: Vec<_> = points.rows().into_iter().map(|point| alone(formula, point.as_slice().unwrap())).collect();
    let outputs = components_of(formula.outputs());
    for (from, rows) in (0..9).flat_map(|from| [1, 7, 15, 16, 17, 23, 24, 31, 32, 33, 71].map(|rows| (from, rows))) {
        let some = by_columns.slice_axis(Axis(0), (from..from + rows).into());
        let mut results = Array2::<f64>::zeros([outputs + formula.batch_entries().len(), 90]).reversed_axes();
        {
            let taken = results.slice_axis_mut(Axis(0), (9 - from..9 - from + rows).into());
            let (mut value, mut jacobian) = taken.split_at(Axis(1), outputs);
            let [value, jacobian] =
                [&mut value, &mut jacobian].map(|table| table.columns_mut().into_iter().collect::<Vec<_>>());
            let inputs: Vec<_> = some.columns().into_iter().collect();
            // They include golden points that are not allowed.
            let found = formula.batch_value_and_jacobian(&inputs, &mut { value }, &mut { jacobian });
            let refused = refused(&expected[from..from + rows]);
            assert_eq!(format!("{:?}", found.err()), format!("{refused:?}"), "{rows} rows from {from}");
        }
        let (before, found) = results.view().split_at(Axis(0), 9 - from);
        let (found, after) = found.split_at(Axis(0), rows);
        assert!(before.iter().chain(after).all(|x| *x == 0.0), "{rows} rows from {from}");
        assert_rows("slot.friction", &some.to_owned(), &found.to_owned(), &expected[from..from + rows]);
    }
}

#[test]
fn columns_begin_with_different_lines_of_the_cache() {
    for (count, rows) in [(0, 5), (3, 1), (4, 7), (5, 8), (2, 4096)] {
        let table = jointproof::toolkit::batch::columns(count, rows);
        assert_eq!((table.dim(), table.iter().all(|x| *x == 0.0)), ((count, rows), true));
        let places: Vec<_> = table.rows().into_iter().map(|column| column.as_ptr() as usize).collect();
        assert!(places.iter().all(|place| place % 64 == 0), "{count} {rows}: {places:?}");
        assert!(places.windows(2).all(|pair| (pair[1] - pair[0]) / 64 % 2 == 1), "{count} {rows}: {places:?}");
    }
}

#[test]
fn every_row_has_its_own_bits_on_any_number_of_threads() {
    // So the result does not depend on how rows are shared out.
    let formula = find("slot.friction").unwrap();
    // Enough rows for more than one thread.
    let points = points(formula, 9000, 30);
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| compare(formula, &points));
    }
}

#[test]
fn a_number_may_stand_for_all_rows() {
    let (f2, f3) = (arr0(3.0), [4.0; 100]);
    let mut forces = [0.0; 100];
    value::<ContactForce>(&[f2.broadcast(100).unwrap(), (&f3).into()], &mut [(&mut forces).into()]).unwrap();
    assert_eq!(forces, [5.0; 100]);
}

#[test]
fn columns_that_do_not_fit_are_refused() {
    let (short, long) = ([1.0; 2], [1.0; 3]);
    let (short, long) = (ArrayView1::from(&short), ArrayView1::from(&long));
    let (mut forces, mut one) = ([0.0; 3], [0.0; 3]);
    let (forces, one) = (&mut [ArrayViewMut1::from(&mut forces)], &mut [ArrayViewMut1::from(&mut one)]);
    let found = value::<ContactForce>(&[long], forces).unwrap_err();
    assert_eq!(found, Error::Columns { part: Part::Inputs, found: 1, expected: 2 });
    assert_eq!(found.to_string(), "inputs: 1 columns; allowed are 2");
    let found = value::<ContactForce>(&[long, short], forces).unwrap_err();
    assert_eq!(found, Error::Length { part: Part::Inputs, column: 1, found: 2, expected: 3 });
    assert_eq!(found.to_string(), "inputs, column 1: 2 rows; allowed are 3, as in the first column");
    let found = value::<ContactForce>(&[short, short], forces).unwrap_err();
    assert_eq!(found, Error::Length { part: Part::Value, column: 0, found: 3, expected: 2 });
    let found = value_and_jacobian::<ContactForce>(&[long, long], forces, one).unwrap_err();
    assert_eq!(found, Error::Columns { part: Part::Jacobian, found: 1, expected: 2 });
    let none: ArrayView1<f64> = (&[]).into();
    value::<ContactForce>(&[none, none], &mut [(&mut []).into()]).unwrap();
}

#[test]
fn columns_in_one_piece_and_with_a_stride_go_together() {
    let formula = find("slot.friction").unwrap();
    let points = points(formula, 1000, 0);
    let (rows, outputs) = (points.nrows(), components_of(formula.outputs()));
    let rows_apart = columns(&points);
    let pieces = points.t().as_standard_layout().to_owned();
    let whole: Vec<_> = pieces.rows().into_iter().collect();
    for inputs in [&rows_apart, &whole] {
        let (mut strided, mut others) = (Array2::zeros((rows, 2)), Array2::zeros((outputs - 1, rows)));
        let mut value: Vec<_> = strided.columns_mut().into_iter().take(1).chain(others.rows_mut()).collect();
        // The rejected golden points are NaN.
        let _ = formula.batch_value(inputs, &mut value);
        for (row, point) in points.rows().into_iter().enumerate() {
            let alone = formula.value(point.as_slice().unwrap()).unwrap_or_else(|_| vec![f64::NAN; outputs]);
            let found: Vec<f64> = value.iter().map(|column| column[row]).collect();
            assert_eq!(bits(&found), bits(&alone), "{point}");
        }
    }
}
