//! The program as a user runs it: what each command reads, answers and refuses.

mod axis;
mod bands;
mod ends;
mod extremes;
mod files;
mod flicker;
mod fuzz;
mod measure;
mod measure_refuses;
mod names;
mod numbers;
mod paint;
mod paint_refuses;
mod program;
mod run;
mod scene;
mod scene_refuses;
mod scene_says;
mod sensor;
mod sensor_log;
mod sensor_refuses;
