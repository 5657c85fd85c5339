//! Results in statics.

/// The value of a `Result` in a `static` or `const`; an error ends the build with its message.
///
/// It takes every error with a `message`: those of all constructors that are `const fn`, as
/// [`FitError::message`](crate::sensor::FitError::message).
///
/// ```
/// use nanospectra::const_unwrap;
/// use nanospectra::sensor::{AutoExposure, chip::as7341};
///
/// static AUTO: AutoExposure<'static> = const_unwrap!(AutoExposure::new(&as7341::LADDER));
/// assert_eq!(AUTO.middle(), 7);
/// ```
#[macro_export]
macro_rules! const_unwrap {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => panic!("{}", error.message()),
        }
    };
}
