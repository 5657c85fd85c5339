//! Reads the spectra of CxF2 and CxF3, the color exchange format of X-Rite.

use super::contents::{Contents, NANOMETERS, Spectrum, highest, part};
use super::xml::{self, Tag};
use crate::grid::Said;
use crate::refusal::{Note, Refusal, Setting};
use crate::text::number::{Decimal, number};
use std::collections::HashMap;

/// The standard defines reflectances up to this as parts of 1, for fluorescent samples.
const FLUORESCENT: f64 = 3.0;

/// The step that nearly all instruments have.
const COMMON_STEP: f64 = 10.0;

/// A spectrum whose steps a later part of the file may state.
struct Raw {
    object: Option<String>,
    name: Option<String>,
    element: String,
    specification: String,
    start: Option<f64>,
    step: Option<f64>,
    /// The wavelengths, if each value has its own.
    places: Vec<f64>,
    values: Vec<f64>,
    lines: (usize, usize),
}

/// What the file says of how spectra were measured.
#[derive(Default)]
struct Specification {
    id: String,
    kind: String,
    start: Option<f64>,
    step: Option<f64>,
}

/// What has been read.
#[derive(Default)]
struct Reader {
    contents: Contents,
    object: Option<String>,
    open: Option<Raw>,
    /// The wavelength of the value that is being read.
    place: Option<f64>,
    spectra: Vec<Raw>,
    specifications: Vec<Specification>,
}

/// Reads the spectra of a file.
pub fn read(text: &str) -> Result<Contents, Refusal> {
    let mut reader = Reader::default();
    xml::walk(text, |tag, line| match tag {
        Tag::Open { name, attributes } => {
            reader.open(name, attributes, line);
            Ok(())
        }
        Tag::Close { name, parent, text } => reader.close(name, parent, text, line),
    })?;
    let spectra = std::mem::take(&mut reader.spectra);
    if spectra.is_empty() {
        let what = "the file has colors without their spectra, or none; export it with spectral values";
        return Err(Refusal::of(what));
    }
    let mut counts: HashMap<Option<&str>, usize> = HashMap::new();
    for raw in &spectra {
        *counts.entry(raw.object.as_deref()).or_default() += 1;
    }
    let several: Vec<bool> = spectra.iter().map(|raw| counts[&raw.object.as_deref()] > 1).collect();
    let mut contents = std::mem::take(&mut reader.contents);
    let units = units(&spectra, &reader.specifications, &mut contents.notes);
    for ((raw, several), unit) in spectra.into_iter().zip(several).zip(units) {
        add(raw, several, unit, &reader.specifications, &mut contents)?;
    }
    Ok(contents)
}

impl Reader {
    fn open(&mut self, name: &str, attributes: &[(String, String)], line: usize) {
        let text = |wanted: &str| xml::attribute(attributes, wanted).map(str::to_owned);
        let value =
            |wanted: &str| xml::attribute(attributes, wanted).and_then(|text| number(text, Decimal::Point));
        match name {
            "Object" | "Sample" | "Color" => {
                self.object = text("Name").or_else(|| text("Id")).filter(|name| !name.is_empty());
            }
            "ColorSpecification" => {
                let id = text("Id").unwrap_or_default();
                self.specifications.push(Specification { id, ..Specification::default() });
            }
            "WavelengthRange" => {
                if let Some(specification) = self.specifications.last_mut() {
                    specification.start = value("StartWL");
                    specification.step = value("Increment");
                }
            }
            "Tag" => {
                if let (Some(name), Some(value)) = (text("Name"), text("Value")) {
                    self.contents.fact(line, &name, &value);
                }
            }
            "SpectralPoint" => self.place = value("WL"),
            "Value" if self.open.is_some() => {
                self.place = text("Name")
                    .and_then(|name| number(name.trim_start_matches("SPECTRAL_"), Decimal::Point));
            }
            _ if name.ends_with("Spectrum") => {
                self.open = Some(Raw {
                    object: self.object.clone(),
                    name: text("Name"),
                    element: name.to_owned(),
                    specification: text("ColorSpecification")
                        .or_else(|| text("Conditions"))
                        .unwrap_or_default(),
                    start: value("StartWL"),
                    step: value("Increment").or_else(|| value("Interval")),
                    places: Vec::new(),
                    values: Vec::new(),
                    lines: (line, line),
                });
            }
            _ => {}
        }
    }

    fn close(&mut self, name: &str, parent: &str, text: &str, line: usize) -> Result<(), Refusal> {
        match name {
            "SpectralPoint" | "Value" if self.open.is_some() => {
                let (Some(open), Some(place)) = (&mut self.open, self.place.take()) else {
                    let what = format!("this {name} does not say its wavelength as a number; complete it");
                    return Err(Refusal::at(line, what));
                };
                open.places.push(place);
                open.values.push(value(text, line)?);
            }
            "Name" if matches!(parent, "Object" | "Sample" | "Color") && !text.is_empty() => {
                self.object = Some(text.to_owned());
            }
            "MeasurementType" => {
                if let Some(specification) = self.specifications.last_mut() {
                    specification.kind = text.to_owned();
                }
            }
            _ if name.ends_with("Spectrum") => {
                if let Some(mut raw) = self.open.take().filter(|raw| raw.element == name) {
                    if raw.places.is_empty() {
                        let parts = text.split_whitespace();
                        raw.values = parts.map(|part| value(part, line)).collect::<Result<_, _>>()?;
                    }
                    raw.lines.1 = line;
                    if !raw.values.is_empty() {
                        self.spectra.push(raw);
                    }
                }
            }
            _ if matches!(parent, "FileInformation" | "FileDescription" | "Device") => {
                self.contents.fact(line, name, text);
            }
            _ => {}
        }
        Ok(())
    }
}

fn value(text: &str, line: usize) -> Result<f64, Refusal> {
    number(text, Decimal::Point).ok_or_else(|| {
        Refusal::at(line, format!("'{text}' in the spectrum that ends here is not a number; correct it"))
    })
}

/// Returns the units of all spectra. Percent is a question of the whole file.
fn units(spectra: &[Raw], specifications: &[Specification], notes: &mut Vec<Note>) -> Vec<Option<String>> {
    let quantity = |raw: &Raw| {
        let kind = specifications.iter().find(|other| other.id == raw.specification);
        let kind = kind.map_or("", |specification| specification.kind.as_str());
        match (raw.element.as_str(), kind) {
            ("ReflectanceSpectrum", _) | (_, "Spectrum_Reflectance") => "reflectance",
            ("TransmittanceSpectrum", _) | (_, "Spectrum_Transmittance" | "Spectrum_TotalTransmittance") => {
                "transmittance"
            }
            // What CxF2 has, which is made for samples.
            ("Spectrum", "") => "reflectance",
            _ => "",
        }
    };
    let mut part_of = |wanted: &str| {
        let chosen = spectra.iter().filter(|raw| quantity(raw) == wanted).flat_map(|raw| &raw.values);
        part(wanted, highest(chosen), FLUORESCENT, notes)
    };
    let (reflectance, transmittance) = (part_of("reflectance"), part_of("transmittance"));
    let mut relative = false;
    let units = spectra
        .iter()
        .map(|raw| match quantity(raw) {
            "reflectance" => Some(reflectance.clone()),
            "transmittance" => Some(transmittance.clone()),
            _ => {
                relative = true;
                Some("relative".to_owned())
            }
        })
        .collect();
    if relative {
        let what = "emissive and custom spectra are relative, because CxF does not say their unit";
        notes.push(Note::assumed(what, Some(Setting::Unit)));
    }
    units
}

/// Adds a spectrum with the wavelengths that it or its specification states.
fn add(
    raw: Raw,
    several: bool,
    unit: Option<String>,
    specifications: &[Specification],
    contents: &mut Contents,
) -> Result<(), Refusal> {
    let line = raw.lines.0;
    let specification = specifications.iter().find(|other| other.id == raw.specification);
    let start = raw.start.or_else(|| specification.and_then(|other| other.start));
    let step = raw.step.or_else(|| specification.and_then(|other| other.step));
    let places = if raw.places.is_empty() {
        let Some(start) = start else {
            let what =
                "neither this spectrum nor its ColorSpecification says StartWL, the first wavelength; add it";
            return Err(Refusal::at(line, what));
        };
        let step = match step.filter(|step| *step > 0.0) {
            Some(step) => step,
            None => assumed(start, &raw, contents)?,
        };
        (0..raw.values.len()).map(|index| start + index as f64 * step).collect()
    } else {
        raw.places
    };
    let name = match (raw.object, raw.name) {
        (Some(object), Some(name)) if several => Some(format!("{object} ({name})")),
        (Some(object), None) if several && !raw.specification.is_empty() => {
            Some(format!("{object} ({})", raw.specification))
        }
        (object, name) => object.or(name),
    };
    if raw.values.len() < 2 {
        let title = name.map_or("a spectrum".to_owned(), |name| format!("'{name}'"));
        contents.notes.push(Note::left_out(format!("{title} in line {line} has one value only")));
        return Ok(());
    }
    contents.add(Spectrum {
        name,
        axis: NANOMETERS.to_owned(),
        places,
        values: raw.values,
        unit: unit.map(|text| Said { text, line }),
        lines: line..=raw.lines.1,
    });
    Ok(())
}

/// Assumes the common step if it leads to the end of the spectra of instruments.
fn assumed(start: f64, raw: &Raw, contents: &mut Contents) -> Result<f64, Refusal> {
    let end = start + COMMON_STEP * (raw.values.len() - 1) as f64;
    if !(650.0..=850.0).contains(&end) {
        let what = format!(
            "the ColorSpecification of this spectrum does not say the Increment between its {} wavelengths; add it",
            raw.values.len()
        );
        return Err(Refusal::at(raw.lines.0, what));
    }
    let note = Note::assumed("the wavelengths are in steps of 10 nm, because the file does not say it", None);
    if !contents.notes.contains(&note) {
        contents.notes.push(note);
    }
    Ok(COMMON_STEP)
}

#[cfg(test)]
mod tests {
    use crate::{Kind, Options, Quantity, Reading, Refusal, Setting, read};

    const FILE: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<cc:CxF xmlns:cc=\"http://colorexchangeformat.com/CxF3-core\">
<cc:FileInformation><cc:Creator>A</cc:Creator><cc:Tag Name=\"Target\" Value=\"B\"/></cc:FileInformation>
<cc:Resources><cc:ObjectCollection>
<cc:Object ObjectType=\"Target\" Name=\"White 50%\" Id=\"1\"><cc:ColorValues>
<cc:ReflectanceSpectrum StartWL=\"400\" ColorSpecification=\"CS1\">0.5 0.6
0.7</cc:ReflectanceSpectrum>
<cc:ColorCIELab ColorSpecification=\"CS1\"><cc:L>50</cc:L></cc:ColorCIELab>
</cc:ColorValues></cc:Object>
<cc:Object ObjectType=\"Target\" Name=\"Black\" Id=\"2\"><cc:ColorValues>
<cc:ReflectanceSpectrum ColorSpecification=\"CS1\" Name=\"M0\">0.01 0.02 0.03</cc:ReflectanceSpectrum>
<cc:EmissiveSpectrum ColorSpecification=\"CS2\" Name=\"E\">10 20 30</cc:EmissiveSpectrum>
</cc:ColorValues></cc:Object>
</cc:ObjectCollection>
<cc:ColorSpecificationCollection><cc:ColorSpecification Id=\"CS1\"><cc:MeasurementSpec>
<cc:MeasurementType>Spectrum_Reflectance</cc:MeasurementType>
<cc:WavelengthRange StartWL=\"400\" Increment=\"20\"/></cc:MeasurementSpec></cc:ColorSpecification>
<cc:ColorSpecification Id=\"CS2\"><cc:MeasurementSpec><cc:MeasurementType>Spectrum_Emissive</cc:MeasurementType>
<cc:WavelengthRange StartWL=\"380\" Increment=\"5\"/></cc:MeasurementSpec></cc:ColorSpecification>
</cc:ColorSpecificationCollection></cc:Resources></cc:CxF>
";

    fn reading(text: &str) -> Result<Reading, Refusal> {
        read(text.as_bytes(), &Options::default())
    }

    #[test]
    fn objects_become_curves() {
        let reading = reading(FILE).unwrap();
        let names: Vec<&str> = reading.curves.iter().filter_map(|curve| curve.name.as_deref()).collect();
        assert_eq!(names, ["White 50%", "Black (M0)", "Black (E)"]);
        let [white, black, emissive] = &reading.curves[..] else { panic!() };
        assert_eq!(
            (&white.wavelengths[..], &white.values[..]),
            (&[400.0, 420.0, 440.0][..], &[0.5, 0.6, 0.7][..])
        );
        assert_eq!(white.unit.map(|unit| (unit.quantity, unit.factor)), Some((Quantity::Reflectance, 1.0)));
        assert_eq!(white.line_range(), 6..=7);
        assert_eq!(black.values, [0.01, 0.02, 0.03]);
        assert_eq!(emissive.wavelengths, [380.0, 385.0, 390.0]);
        assert_eq!(emissive.unit.map(|unit| unit.quantity), Some(Quantity::Relative));
        assert!(reading.facts.iter().any(|fact| fact.name == "Creator" && fact.line == 3));
        assert!(reading.facts.iter().any(|fact| fact.name == "Target" && fact.value == "B"));
    }

    #[test]
    fn second_edition_and_own_wavelengths_are_read() {
        let two = "<CXF xmlns='http://www.gretagmacbeth.com/CXF'><SampleSet><Sample><Name>A1</Name><SampleAttribute>\
                   <Spectrum Conditions='C'><Value Name='400'>0.25</Value><Value Name='410'>0.5</Value></Spectrum>\
                   </SampleAttribute></Sample></SampleSet></CXF>";
        let curve = reading(two).unwrap().curves.remove(0);
        assert_eq!((curve.name.as_deref(), curve.values), (Some("A1"), vec![0.25, 0.5]));
        assert_eq!(curve.unit.map(|unit| unit.quantity), Some(Quantity::Reflectance));
        let custom = "<CxF><Object Name='a'><CustomSpectrum><SpectralPoint WL='380.5'>1</SpectralPoint><SpectralPoint \
                      WL='381.75'>2</SpectralPoint></CustomSpectrum></Object></CxF>";
        assert_eq!(reading(custom).unwrap().curves[0].wavelengths, [380.5, 381.75]);
    }

    #[test]
    fn steps_and_percent_are_assumed_aloud() {
        let thirty_one = vec!["45.5"; 31].join(" ");
        let text = format!(
            "<CxF><Object Name='a'><ReflectanceSpectrum StartWL='400'>{thirty_one}</ReflectanceSpectrum></Object></CxF>"
        );
        let reading = reading(&text).unwrap();
        assert_eq!(reading.curves[0].wavelengths[30], 700.0);
        assert_eq!(reading.curves[0].values[0], 0.455);
        let assumed = || reading.notes.iter().filter(|note| note.kind == Kind::Assumed);
        assert!(assumed().any(|note| note.setting == Some(Setting::Percent)));
        assert!(assumed().any(|note| note.what.contains("10 nm")));
    }

    #[test]
    fn faults_are_refused_with_their_lines() {
        let line = |text: &str| reading(text).unwrap_err().line;
        assert_eq!(line(&FILE.replace("0.7<", "x<")), Some(7));
        assert_eq!(line(&FILE.replace("Increment=\"20\"", "")), Some(6));
        assert_eq!(line(&FILE.replace("StartWL=\"400\"", "")), Some(6));
        assert_eq!(
            line("<CxF><A>\n<CustomSpectrum><SpectralPoint>1</SpectralPoint></CustomSpectrum></A></CxF>"),
            Some(2)
        );
        assert!(reading("<CxF><Object Name='a'/></CxF>").unwrap_err().what.contains("spectral values"));
    }

    #[test]
    fn no_cut_panics() {
        for end in 0..FILE.len() {
            let _ = reading(&FILE[..end]);
        }
    }
}
