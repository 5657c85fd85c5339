//! What light meets: surfaces, films, volumes, dyes, mirrors.

mod any_matter_at_all;
mod brdf;
mod films;
mod films_properties;
mod fluorescence;
mod hard_cases_films;
mod hard_cases_surfaces;
mod polarization;
mod slab;
mod surfaces_swept;
mod volumes;
mod worst_layers;
mod worst_matter;
mod worst_scattering;
