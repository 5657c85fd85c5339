// Scenes in TOML for the comparison with the program: every lamp, both observers and every part.
export const RECIPES = [
  `title = "a black body through gray glass"
[lamp]
blackbody_k = 2856
illuminance_lx = 300
[[part]]
filter.flat = 0.5
[[part]]
surface.points = [[400, 0.1], [550, 0.6], [700, 0.3]]`,

  `title = "crossed polarizers, a wave plate between them"
eye = "CIE 1964"
[lamp]
points = [[380, 0.2], [450, 1.0], [600, 0.7], [780, 0.9]]
[[part]]
polarizer = { axis_deg = 0, along = 0.9, across = 0.01 }
[[part]]
retarder = { path_difference_nm = 560, axis_deg = 45 }
[[part]]
polarizer = { axis_deg = 90 }`,

  `title = "gold at an angle, a film in transmission, ink"
[lamp]
cie = "FL11"
[[part]]
film = { n = 1.8, thickness_nm = 450, n_behind = 1.5, transmitted = true }
[[part]]
mirror = { n = 0.6, k = 2.1, angle_deg = 60, axis_deg = 30 }
[[part]]
filter.absorbance_per_cm = [[380, 2.0], [500, 0.5], [780, 0.1]]
filter.path_cm = 0.4`,

  `title = "a dye under a hot black body"
[lamp]
blackbody_k = 20000
[[part]]
dye.reflectance = [[380, 0.05], [500, 0.2], [780, 0.8]]
dye.absorption = [[380, 0.8], [480, 0.6], [520, 0.0]]
dye.emission = [[520, 0.0], [560, 1.0], [620, 0.0]]
dye.quantum_yield = 0.8`,
];
