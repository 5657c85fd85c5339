//! What the pictures of the guide must be so that they can be inlined into a page of rustdoc as well as shown
//! as images. `--check` says whether they are up to date.

const PICTURES: [(&str, &str); 2] = [
    ("ns-chain", include_str!("../../../../src/guide/chain.svg")),
    ("ns-frontier", include_str!("../../../../src/guide/frontier.svg")),
];

#[test]
fn pictures_are_one_block_of_html_in_markdown() {
    for (name, text) in PICTURES {
        assert!(text.starts_with(&format!("<svg class=\"{name}\" ")) && text.ends_with("</svg>\n"), "{name}");
        assert!(
            text.lines().all(|line| !line.trim().is_empty()),
            "an empty line of {name} would end the block"
        );
        assert!(text.len() < 20_000, "{name} has {} bytes", text.len());
        for word in ["role=\"img\"", "<title>", "viewBox=\"0 0 720 ", "(prefers-color-scheme:dark)"] {
            assert!(text.contains(word), "{name} has no {word}");
        }
    }
}

#[test]
fn styles_and_names_of_pictures_reach_nothing_else_on_the_page() {
    for (name, text) in PICTURES {
        let (_, style) = text.split_once("<style>\n").expect("a style");
        let (style, drawing) = style.split_once("\n</style>").expect("its end");
        for selector in
            style.lines().filter_map(|line| line.split_once('{')).flat_map(|rule| rule.0.split(','))
        {
            let own = selector.split(' ').any(|part| part == format!(".{name}"));
            assert!(own || selector.starts_with("@media"), "{name}: {selector}");
        }
        for id in drawing.split(" id=\"").skip(1) {
            assert!(id.starts_with(name), "{name}: {id:.20}");
        }
    }
}

#[test]
fn texts_are_large_enough_where_the_page_is_as_wide_as_the_picture() {
    for (name, text) in PICTURES {
        for size in text.split("font-size=\"").skip(1) {
            let size: f64 = size.split('"').next().and_then(|size| size.parse().ok()).expect("a number");
            assert!(size >= 13.0, "{name}: {size} px");
        }
    }
}

#[test]
fn the_folded_matrix_gives_the_color_of_the_whole_chain() {
    let (_, chain) = PICTURES[0];
    let numbers: Vec<&str> = chain.lines().filter(|line| line.parse::<f64>().is_ok()).collect();
    let (whole, folded) = numbers.split_at(3);
    assert_eq!(whole, folded);
}
