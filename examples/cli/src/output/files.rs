//! Writes files, which come to their places whole, or not at all.
//!
//! Every file that the program writes is one of a [`Files`]. It is written under another name in the same
//! folder, and renamed when the run has succeeded. A run that fails removes what it wrote.

use crate::failure::Failure;
use file_id::{FileId, get_file_id};
use std::collections::HashSet;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, TempPath};

/// The streams of the program, which may be files too. (Where they have no such names, none is found.)
const STREAMS: [&str; 3] = ["/dev/stdin", "/dev/stdout", "/dev/stderr"];

/// The files of a run, and the directories made for them. All are removed again unless [`Files::keep`]
/// succeeds.
pub struct Files {
    /// What the user should name if a file cannot be written: a directory or a place.
    wanted: &'static str,
    /// Whether files may be replaced.
    force: bool,
    /// The files that the run reads, which are never replaced.
    inputs: HashSet<FileId>,
    /// The files to be, each with its place.
    written: Vec<(TempPath, PathBuf)>,
    /// The new files that are in their places.
    placed: Vec<PathBuf>,
    /// The new directories, each before the one that it lies in.
    directories: Vec<PathBuf>,
}

impl Files {
    /// Returns an empty set for a run that reads these files.
    pub fn new(
        wanted: &'static str,
        force: bool,
        inputs: impl IntoIterator<Item = impl AsRef<Path>>,
    ) -> Self {
        let inputs = inputs.into_iter().filter_map(|path| get_file_id(path).ok());
        let inputs = inputs.chain(STREAMS.into_iter().filter_map(|path| get_file_id(path).ok())).collect();
        Files { wanted, force, inputs, written: Vec::new(), placed: Vec::new(), directories: Vec::new() }
    }

    /// Makes a directory if it is missing, with those that it lies in.
    pub fn make_directory(&mut self, directory: &Path) -> Result<(), Failure> {
        let missing = directory.ancestors().take_while(|path| path.symlink_metadata().is_err());
        self.directories.extend(missing.map(Path::to_path_buf));
        fs::create_dir_all(directory).map_err(|error| self.refused(directory, &error))
    }

    /// Writes the text of a file that [`Files::keep`] will put in this place.
    pub fn write(&mut self, path: PathBuf, text: &str) -> Result<(), Failure> {
        self.check(&path)?;
        let written = write_beside(&path, text).map_err(|error| self.refused(&path, &error))?;
        self.written.push((written, path));
        Ok(())
    }

    /// Returns the places of the files, in the order in which they were written.
    pub fn paths(&self) -> Vec<&Path> {
        self.written.iter().map(|(_, path)| path.as_path()).collect()
    }

    /// Puts the files in their places, since the run has succeeded.
    pub fn keep(mut self) -> Result<(), Failure> {
        for (written, path) in std::mem::take(&mut self.written) {
            match written.persist_noclobber(&path) {
                Ok(()) => self.placed.push(path),
                Err(failed) if self.force => {
                    self.check(&path)?;
                    failed.path.persist(&path).map_err(|failed| self.refused(&path, &failed.error))?;
                }
                Err(failed) => return Err(self.refused(&path, &failed.error)),
            }
        }
        self.placed.clear();
        self.directories.clear();
        Ok(())
    }

    /// Returns a failure if a file must not take this place.
    fn check(&self, path: &Path) -> Result<(), Failure> {
        let Ok(found) = path.symlink_metadata() else { return Ok(()) };
        let wanted = self.wanted;
        let what = if !found.is_file() {
            format!("there is a link, a directory or a device of this name; name another {wanted}")
        } else if get_file_id(path).is_ok_and(|file| self.inputs.contains(&file)) {
            format!("this run reads or writes the file itself; name another {wanted}")
        } else if !self.force {
            format!("the file exists already; name another {wanted}, or give --force to replace it")
        } else {
            return Ok(());
        };
        Err(Failure::of(format_args!("--svg {}", path.display()), what))
    }

    fn refused(&self, path: &Path, error: &io::Error) -> Failure {
        let what = match error.kind() {
            ErrorKind::AlreadyExists => "another program has just made it".into(),
            kind => kind.to_string(),
        };
        let what =
            format!("the picture cannot be written ({what}); name a {} that you may write to", self.wanted);
        Failure::of(format_args!("--svg {}", path.display()), what)
    }
}

impl Drop for Files {
    /// Removes what is not kept. What cannot be removed stays, since the run already has a failure to report.
    fn drop(&mut self) {
        self.written.clear();
        for path in &self.placed {
            let _ = fs::remove_file(path);
        }
        for directory in &self.directories {
            let _ = fs::remove_dir(directory);
        }
    }
}

/// Writes a file of another name beside a path, down to the disk, which may turn out to be full only then.
fn write_beside(path: &Path, text: &str) -> io::Result<TempPath> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".nanospectra-").suffix(".tmp");
    // Others may read it as any new file, which they may not in a temporary one.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(text.as_bytes())?;
    file.as_file().sync_all()?;
    Ok(file.into_temp_path())
}
