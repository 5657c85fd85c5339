//! The program as a user runs it: what each command reads, answers and refuses.

mod ends;
mod files;
mod measure;
mod measure_refuses;
mod names;
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
