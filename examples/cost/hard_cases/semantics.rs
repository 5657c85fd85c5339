//! Rules of behaviour rather than of rounding, each with the test that pins it.

use super::Semantic;

pub const ALL: &[Semantic] = &[
    Semantic {
        what: "unsorted wavelengths are an error, never sorted silently; so are duplicates",
        test: "spectrum/semantics::samples_that_are_no_spectrum_are_refused_and_never_sorted",
    },
    Semantic {
        what: "a line on an edge goes half to each side, in any order of construction",
        test: "spectrum/semantics::a_line_on_an_edge_goes_half_to_each_side_in_any_order",
    },
    Semantic {
        what: "a line keeps its power, and what lies outside the range is reported",
        test: "spectrum/semantics::a_line_keeps_its_power_and_what_is_lost_is_reported",
    },
    Semantic {
        what: "beyond the samples lights are zero and reflectances hold",
        test: "spectrum/semantics::beyond_the_samples_lights_are_dark_and_surfaces_go_on",
    },
    Semantic {
        what: "light from below a surface gives 0 (no absolute value of the cosine)",
        test: "matter/hard_cases_surfaces::grazing_light_leaves_brdfs_finite_and_light_from_below_gives_nothing",
    },
    Semantic {
        what: "NaN in is NaN out: spectra",
        test: "spectrum/semantics::nan_in_is_nan_out_and_stays_where_it_is",
    },
    Semantic { what: "NaN in is NaN out: colours", test: "color/spaces::nan_is_never_hidden" },
    Semantic { what: "NaN in is NaN out: paths", test: "path/chain::nan_in_is_nan_out_by_every_way" },
    Semantic {
        what: "NaN in is NaN out: geometry",
        test: "radiometry/properties::nan_in_any_argument_stays_nan",
    },
    Semantic { what: "no samples make it panic", test: "spectrum/properties::no_samples_make_it_panic" },
    Semantic {
        what: "no finite spectrum makes it panic",
        test: "spectrum/properties::no_finite_spectrum_makes_it_panic",
    },
    Semantic {
        what: "N = 1, 2 and 3 are spectra too",
        test: "spectrum/semantics::one_two_and_three_bands_are_spectra_too",
    },
    Semantic {
        what: "resampling to the same grid gives the same bits",
        test: "spectrum/semantics::resampling_to_the_same_grid_gives_the_same_bits_at_every_number_of_bands",
    },
    Semantic {
        what: "the average of a constant is that constant, to the bit, at every N",
        test: "spectrum/semantics::the_average_of_a_constant_is_that_constant_at_every_number_of_bands",
    },
    Semantic {
        what: "a positive spectrum from counts has a bound of steps and says if it did not converge",
        test: "sensor/reconstruction::counts_that_no_light_makes_end_in_the_dark",
    },
];
