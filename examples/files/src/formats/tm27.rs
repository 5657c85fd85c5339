//! Reads the spectra of IES TM-27-14 and TM-27-20, whose files end in `.spdx`.

use super::contents::{Contents, NANOMETERS, Spectrum, TWICE, highest, part};
use super::xml::{self, Tag};
use crate::grid::Said;
use crate::refusal::{Note, Refusal, Setting};
use crate::text::number::{Decimal, number};
use crate::unit::Unit;

/// What is known of a `SpectralDistribution` before its end.
struct Open {
    line: usize,
    quantity: Option<Said>,
    places: Vec<f64>,
    values: Vec<f64>,
}

/// Reads the spectra of a file.
pub fn read(text: &str) -> Result<Contents, Refusal> {
    let mut contents = Contents::default();
    let mut description: Option<String> = None;
    let mut open: Option<Open> = None;
    let mut place = None;
    xml::walk(text, |tag, line| {
        match tag {
            Tag::Open { name: "SpectralDistribution", .. } => {
                open = Some(Open { line, quantity: None, places: Vec::new(), values: Vec::new() });
            }
            Tag::Open { name: "SpectralData", attributes } => {
                let stated = xml::attribute(attributes, "wavelength");
                let Some(nm) = stated.and_then(|text| number(text, Decimal::Point)) else {
                    let what = "SpectralData has no number as its attribute 'wavelength'; complete it";
                    return Err(Refusal::at(line, what));
                };
                place = Some(nm);
            }
            Tag::Close { name: "SpectralData", text, .. } => {
                let Some(value) = number(text, Decimal::Point) else {
                    let what = format!("'{text}' is not a number; correct it or take the element out");
                    return Err(Refusal::at(line, what));
                };
                if let (Some(open), Some(nm)) = (&mut open, place.take()) {
                    open.places.push(nm);
                    open.values.push(value);
                }
            }
            Tag::Close { name: "SpectralQuantity", text, .. } => {
                contents.fact(line, "SpectralQuantity", text);
                if let Some(open) = &mut open {
                    open.quantity = Some(Said { text: text.to_owned(), line });
                }
            }
            Tag::Close { name: "SpectralDistribution", .. } => {
                if let Some(open) = open.take() {
                    end(open, line, description.clone(), &mut contents)?;
                }
            }
            Tag::Close { name, text, .. } => {
                if name == "Description" && !text.is_empty() {
                    description = Some(text.to_owned());
                }
                contents.fact(line, name, text);
            }
            Tag::Open { .. } => {}
        }
        Ok(())
    })?;
    if contents.grids.is_empty() {
        return Err(Refusal::of("the file has no SpectralDistribution with SpectralData; export it again"));
    }
    Ok(contents)
}

/// Adds a spectrum when its element ends.
fn end(open: Open, line: usize, name: Option<String>, contents: &mut Contents) -> Result<(), Refusal> {
    if open.values.is_empty() {
        return Err(Refusal::at(open.line, "this SpectralDistribution has no SpectralData; export it again"));
    }
    let unit = match &open.quantity {
        None => {
            let what = "the values are relative, because the file has no SpectralQuantity";
            contents.notes.push(Note::assumed(what, Some(Setting::Unit)));
            "relative".to_owned()
        }
        Some(said) => unit(said, highest(&open.values), &mut contents.notes)?,
    };
    let at = open.quantity.map_or(open.line, |said| said.line);
    contents.add(Spectrum {
        name,
        axis: NANOMETERS.to_owned(),
        places: open.places,
        values: open.values,
        unit: Some(Said { text: unit, line: at }),
        lines: open.line..=line,
    });
    Ok(())
}

/// Returns the unit that TM-27 has for a quantity.
fn unit(said: &Said, high: f64, notes: &mut Vec<Note>) -> Result<String, Refusal> {
    let quantity = said.text.to_lowercase();
    let unit = match quantity.as_str() {
        "relative" => return Ok(quantity),
        "flux" => "W/nm",
        "irradiance" => "W/m2/nm",
        "radiance" => "W/m2/sr/nm",
        "intensity" => "W/sr/nm",
        "exitance" => {
            let what = "the exitance, which leaves a surface, is read as an irradiance, which falls on one";
            notes.push(Note::assumed(what, Some(Setting::Unit)));
            "W/m2/nm"
        }
        "reflectance" | "r-factor" | "rfactor" => return Ok(part("reflectance", high, TWICE, notes)),
        "transmittance" | "t-factor" | "tfactor" => return Ok(part("transmittance", high, TWICE, notes)),
        "absorptance" => {
            let what =
                "an absorptance is neither a light nor a reflectance or transmittance; export one of these";
            return Err(Refusal::at(said.line, what));
        }
        // Some programs write the unit instead.
        _ if Unit::in_heading(&said.text).is_some() => return Ok(said.text.clone()),
        _ => {
            let what = format!("the values are relative, because SpectralQuantity says '{}'", said.text);
            notes.push(Note::assumed(what, Some(Setting::Unit)));
            return Ok("relative".to_owned());
        }
    };
    Ok(format!("{quantity} ({unit})"))
}

#[cfg(test)]
mod tests {
    use crate::{Kind, Options, Quantity, Reading, Refusal, Setting, read};

    fn file(quantity: &str, data: &str) -> String {
        format!(
            "<?xml version=\"1.0\"?>\n<IESTM2714 xmlns=\"iestm2714\" version=\"1.0\">\n<Header>\n\
             <Description>Lamp &amp; filter</Description>\n<ReportNumber>7</ReportNumber>\n</Header>\n\
             <SpectralDistribution>\n<SpectralQuantity>{quantity}</SpectralQuantity>\n\
             <BandwidthFWHM>2.0</BandwidthFWHM>\n{data}\n</SpectralDistribution>\n</IESTM2714>\n"
        )
    }

    const DATA: &str = "<SpectralData wavelength=\"400.0\">0.5</SpectralData>\n<SpectralData \
                        wavelength=\"403.1\">0.75</SpectralData>\n<SpectralData \
                        wavelength=\"410\"> 1e-1 </SpectralData>";

    fn reading(text: &str) -> Result<Reading, Refusal> {
        read(text.as_bytes(), &Options::default())
    }

    #[test]
    fn quantities_have_their_units() {
        for (quantity, expected) in [
            ("relative", Quantity::Relative),
            ("flux", Quantity::Flux),
            ("Irradiance", Quantity::Irradiance),
            ("radiance", Quantity::Radiance),
            ("intensity", Quantity::Intensity),
            ("exitance", Quantity::Irradiance),
            ("reflectance", Quantity::Reflectance),
            ("R-Factor", Quantity::Reflectance),
            ("transmittance", Quantity::Transmittance),
            ("other", Quantity::Relative),
            ("W/nm", Quantity::Flux),
        ] {
            let reading = reading(&file(quantity, DATA)).unwrap();
            let [curve] = &reading.curves[..] else { panic!("{quantity}") };
            let unit = curve.unit.unwrap();
            assert_eq!((unit.quantity, unit.factor), (expected, 1.0), "{quantity}");
            assert_eq!(curve.wavelengths, [400.0, 403.1, 410.0]);
            assert_eq!(curve.values, [0.5, 0.75, 0.1]);
            assert_eq!(curve.name.as_deref(), Some("Lamp & filter"));
            assert_eq!(curve.line_range(), 7..=13);
            let fact = |name: &str| reading.facts.iter().find(|fact| fact.name == name).unwrap();
            assert_eq!((fact("ReportNumber").line, fact("ReportNumber").value.as_str()), (5, "7"));
            assert_eq!(fact("BandwidthFWHM").value, "2.0");
        }
        assert_eq!(reading(&file("absorptance", DATA)).unwrap_err().line, Some(8));
    }

    #[test]
    fn percent_is_said() {
        let percent = DATA.replace("0.5<", "45<").replace("0.75<", "5<");
        let reading = reading(&file("reflectance", &percent)).unwrap();
        assert_eq!(reading.curves[0].values, [0.45, 0.05, 0.001]);
        let said = reading.notes.iter().find(|note| note.setting == Some(Setting::Percent)).unwrap();
        assert_eq!(said.kind, Kind::Assumed);
    }

    #[test]
    fn prefixes_and_several_spectra_are_read() {
        let text =
            file("relative", DATA).replace("<Spectral", "<t:Spectral").replace("</Spectral", "</t:Spectral");
        assert_eq!(reading(&text).unwrap().curves.len(), 1);
        let one = "<SpectralDistribution><SpectralQuantity>flux</SpectralQuantity>";
        let text = format!(
            "<IESTM2720>{one}{DATA}</SpectralDistribution>{one}{DATA}</SpectralDistribution></IESTM2720>"
        );
        assert_eq!(reading(&text).unwrap().curves.len(), 2);
    }

    #[test]
    fn faults_are_refused_with_their_lines() {
        let line = |text: String| reading(&text).unwrap_err().line;
        assert_eq!(line(file("flux", &DATA.replace("0.75", "high"))), Some(11));
        assert_eq!(line(file("flux", &DATA.replace("\"403.1\"", "\"\""))), Some(11));
        assert_eq!(line(file("flux", "")), Some(7));
        assert_eq!(line(file("flux", DATA).replace("</IESTM2714>", "")), Some(2));
        assert!(reading("<IESTM2714></IESTM2714>").is_err());
    }

    #[test]
    fn no_cut_panics() {
        let text = file("flux", DATA);
        for end in 0..text.len() {
            let _ = reading(&text[..end]);
        }
    }
}
