//! Dense linear algebra, just enough.

pub type Matrix3 = [[f64; 3]; 3];

pub fn apply(m: Matrix3, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

pub fn product(a: Matrix3, b: Matrix3) -> Matrix3 {
    a.map(|row| [0, 1, 2].map(|c| row[0] * b[0][c] + row[1] * b[1][c] + row[2] * b[2][c]))
}

pub fn diagonal([a, b, c]: [f64; 3]) -> Matrix3 {
    [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
}

pub fn inverse(m: Matrix3) -> Matrix3 {
    let a = m.iter().map(|row| row.to_vec()).collect();
    let x = solve(a, diagonal([1.0; 3]).iter().map(|row| row.to_vec()).collect());
    [0, 1, 2].map(|r| [x[r][0], x[r][1], x[r][2]])
}

/// X of A X = B by Gaussian elimination with partial pivoting.
pub fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = a.len();
    for column in 0..n {
        let pivot = (column..n)
            .max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs()))
            .expect("at least one row is left");
        assert!(a[pivot][column] != 0.0, "singular matrix");
        a.swap(column, pivot);
        b.swap(column, pivot);
        let (pivot_a, pivot_b) = (a[column].clone(), b[column].clone());
        for row in 0..n {
            let factor = a[row][column] / pivot_a[column];
            if row == column || factor == 0.0 {
                continue;
            }
            a[row].iter_mut().zip(&pivot_a).for_each(|(x, p)| *x -= factor * p);
            b[row].iter_mut().zip(&pivot_b).for_each(|(x, p)| *x -= factor * p);
        }
    }
    for row in 0..n {
        let divisor = a[row][row];
        b[row].iter_mut().for_each(|x| *x /= divisor);
    }
    b
}
