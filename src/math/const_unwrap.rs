//! A macro to unwrap results in statics.

/// Returns the value of a `Result` in a `static` or `const`, where an error stops the build with its message.
///
/// It takes every error type that has a method `message`, such as
/// [`FitError::message`](crate::sensor::FitError::message). The errors of all constructors that are
/// `const fn` have one.
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
