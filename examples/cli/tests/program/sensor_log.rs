//! The log that comes with the command sensor is what its simulation says.

use nanospectra::radiometry::illuminance;
use nanospectra::sensor::chip::as7341;
use nanospectra_cli::sensor::simulate;

const SHIPPED: &str = include_str!("../../data/known_lamps.csv");

#[test]
fn the_shipped_log_is_the_simulated_one_byte_for_byte() {
    // cargo run --release -- sensor --simulate > examples/cli/data/known_lamps.csv
    assert!(simulate::log() == SHIPPED, "not the same; make it again");
}

#[test]
fn counts_of_the_log_scatter_about_the_lamps_as_its_header_says() {
    let mut scatter = Vec::new();
    for (label, name, lux) in simulate::LAMPS {
        let lamp = simulate::lamp(name, lux);
        assert!((illuminance(&lamp) / lux - 1.0).abs() < 1e-5);
        let row = SHIPPED.lines().find(|line| line.split(',').nth(1) == Some(label)).expect("a row");
        let cells: Vec<f64> = row.split(',').filter_map(|cell| cell.parse().ok()).skip(1).collect();
        let [gain, atime, astep] = cells[cells.len() - 11..cells.len() - 8] else { panic!("{row}") };
        let exposure = as7341::exposure(gain as f32, atime as u8, astep as u16);
        for (count, basic) in cells[cells.len() - 8..].iter().zip(simulate::basic(&lamp)) {
            let true_count = basic / f64::from(exposure.per_count());
            let shot = true_count * gain / f64::from(simulate::NOISE.electrons_per_count);
            let read = f64::from(simulate::NOISE.read_counts).powi(2);
            scatter.push((count - true_count) / (shot + read + 1.0 / 12.0).sqrt());
        }
    }
    // 48 of them: the mean square is uncertain by 0.2.
    let mean_square = scatter.iter().map(|sigmas| sigmas * sigmas).sum::<f64>() / scatter.len() as f64;
    println!("mean square {mean_square:.3}, largest {:.2}", scatter.iter().copied().fold(0.0, f64::max));
    assert_eq!(scatter.len(), 48);
    assert!((0.4..1.6).contains(&mean_square) && scatter.iter().all(|sigmas| sigmas.abs() < 4.5));
}

#[test]
fn the_header_says_what_the_simulation_did() {
    let header: String = SHIPPED.lines().filter(|line| line.starts_with('#')).collect();
    for fact in [
        format!("seed {:#x}", simulate::SEED),
        format!("{} basic counts", simulate::COUNTS_PER_W),
        format!("{} Hz, duty {}", simulate::PWM_HZ, simulate::PWM_DUTY),
        "not measured".into(),
    ] {
        assert!(header.contains(&fact), "{fact}");
    }
    assert!((illuminance(&simulate::green_led(300.0)) - 300.0).abs() < 1e-2);
}
