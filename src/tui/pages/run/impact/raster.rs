//! Rasterised picture of an impact: braille dots, half blocks and shades, or ASCII characters.

use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::tui::theme::{GlyphSet, Role, Theme};
use crate::tui::widgets::Canvas;
use cmra_studies::report::chart::scale::whole_below;
use cmra_studies::report::figures::impact::{COILS, Dots, Part, Picture, Place, Shape, Stage};

/// Bits of a braille character, in rows of two dots.
const BRAILLE: [u8; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];

/// Returns the dots of an area of the screen.
pub(super) fn dots_of(area: Rect, glyphs: GlyphSet) -> Dots {
    let (across, down) = glyphs.dots();
    // A cell is twice as high as wide.
    let aspect = 2.0 * f64::from(across) / f64::from(down);
    let count = |cells: u16, dots: u16| f64::from(cells) * f64::from(dots);
    Dots { across: count(area.width, across), down: count(area.height, down), aspect }
}

/// Draws a picture into an area.
pub(super) fn paint(picture: &Picture, stage: &Stage<'_>, area: Rect, canvas: &mut Canvas<'_>) {
    let theme = canvas.theme;
    let mut grid = Grid::new(stage, area, theme.glyphs);
    for shape in picture {
        grid.add(shape);
    }
    for row in 0..area.height {
        for column in 0..area.width {
            let index = usize::from(row) * usize::from(area.width) + usize::from(column);
            let cell = grid.drawn[index].or_else(|| grid.cell(column, row));
            if let Some((character, part)) = cell {
                let mut text = [0; 4];
                let text = character.encode_utf8(&mut text);
                canvas.put_styled(area, (column, row), text, style(part, theme));
            }
        }
    }
}

fn style(part: Part, theme: Theme) -> Style {
    theme.style(match part {
        Part::Projectile => Role::Curve(0),
        Part::Plug => Role::Curve(1),
        Part::Neutral | Part::Mount | Part::Behind => Role::Border,
        Part::Plate | Part::Hole | Part::Stop | Part::Spring | Part::Damper => Role::Text,
    })
}

/// Bodies at the dots of an area.
struct Grid {
    glyphs: GlyphSet,
    cells: (u16, u16),
    /// Number of dots, horizontally and vertically.
    size: (usize, usize),
    left_m: f64,
    top_m: f64,
    dot_m: f64,
    row_m: f64,
    parts: Vec<Option<Part>>,
    /// Cells with their own character, such as lines, used if a cell has no dots.
    drawn: Vec<Option<(char, Part)>>,
}

impl Grid {
    fn new(stage: &Stage<'_>, area: Rect, glyphs: GlyphSet) -> Self {
        let (across, down) = glyphs.dots();
        let size = (
            usize::from(area.width) * usize::from(across),
            usize::from(area.height) * usize::from(down),
        );
        let cells = usize::from(area.width) * usize::from(area.height);
        Self {
            glyphs,
            cells: (area.width, area.height),
            size,
            left_m: stage.left_m,
            top_m: stage.top_m,
            dot_m: stage.dot_m,
            row_m: stage.dot_m * dots_of(area, glyphs).aspect,
            parts: vec![None; size.0 * size.1],
            drawn: vec![None; cells],
        }
    }

    /// Converts a position to dots from the upper left corner; the centre of a dot is at one half.
    fn place(&self, (x_m, y_m): Place) -> Place {
        ((x_m - self.left_m) / self.dot_m, (self.top_m - y_m) / self.row_m)
    }

    fn add(&mut self, shape: &Shape) {
        match shape {
            Shape::Area(part, corners) => {
                let corners: Vec<Place> = corners.iter().map(|at| self.place(*at)).collect();
                self.fill(*part, &corners);
            }
            Shape::Wall(part, x_m) => self.wall(*part, self.place((*x_m, 0.0)).0),
            Shape::Coils(from, to, wide_m) => {
                let (from, to) = (self.place(*from), self.place(*to));
                self.coils(from, to, wide_m / self.row_m);
            }
            Shape::Dashpot(from, to, wide_m, [rod_m, cylinder_m]) => {
                let (from, to) = (self.place(*from), self.place(*to));
                let [rod, cylinder] = [*rod_m, *cylinder_m].map(|x_m| self.place((x_m, 0.0)).0);
                self.dashpot(from, to, wide_m / self.row_m, (rod, cylinder));
            }
        }
    }

    /// Fills a polygon, by the even-odd rule at the centres of dots.
    fn fill(&mut self, part: Part, corners: &[Place]) {
        let mut crossings = Vec::new();
        for row in 0..self.size.1 {
            let y = row as f64 + 0.5;
            crossings.clear();
            for (at, from) in corners.iter().enumerate() {
                let to = corners[(at + 1) % corners.len()];
                if (from.1 <= y) != (to.1 <= y) {
                    crossings.push(from.0 + (y - from.1) / (to.1 - from.1) * (to.0 - from.0));
                }
            }
            crossings.sort_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                let [from, to] = [pair[0], pair[1]].map(|x| dot(x - 0.5, self.size.0));
                for column in from..to {
                    let here = &mut self.parts[row * self.size.0 + column];
                    if part != Part::Hole {
                        *here = Some(part);
                    } else if *here == Some(Part::Plate) {
                        *here = None;
                    }
                }
            }
        }
        if self.glyphs != GlyphSet::Braille
            && matches!(part, Part::Stop | Part::Projectile | Part::Plug)
        {
            self.uncover(part);
        }
    }

    /// Removes lines that are covered by a body drawn later.
    fn uncover(&mut self, part: Part) {
        for row in 0..self.cells.1 {
            for column in 0..self.cells.0 {
                if self.dots(column, row).any(|(_, it)| it == Some(part)) {
                    let index = usize::from(row) * usize::from(self.cells.0) + usize::from(column);
                    self.drawn[index] = None;
                }
            }
        }
    }

    /// Draws a vertical line over the whole height: dotted for the neutral position, hatched at its right for the mount.
    fn wall(&mut self, part: Part, x: f64) {
        if self.glyphs == GlyphSet::Braille {
            let Some(column) = whole(x, self.size.0) else { return };
            for row in 0..self.size.1 {
                if part == Part::Mount {
                    self.set(column, row, part);
                    let hatch = [2, 1, 3, 0][row % 4];
                    if hatch > 0 {
                        self.set(column + hatch, row, part);
                    }
                } else if row % 4 == 1 && self.is_free(column, row) {
                    self.set(column, row, part);
                }
            }
            return;
        }
        let Some(column) = self.column(x).filter(|column| *column < self.cells.0) else { return };
        for row in 0..self.cells.1 {
            if part == Part::Mount {
                self.put(column, row, '│', part);
                self.put(column + 1, row, '/', part);
            } else if self.dots(column, row).all(|(_, it)| it.is_none()) {
                self.put(column, row, ':', part);
            }
        }
    }

    fn coils(&mut self, from: Place, to: Place, wide: f64) {
        if self.glyphs != GlyphSet::Braille {
            let row = self.row(from.1);
            let (Some(first), Some(end)) = (self.column(from.0), self.column(to.0)) else { return };
            for column in first..end {
                let character = if (column - first).is_multiple_of(2) { '/' } else { '\\' };
                self.put(column, row, character, Part::Spring);
            }
            return;
        }
        let steps = 4 * COILS;
        let lead = 0.06 * (to.0 - from.0);
        let along = |step: u32| {
            let part = f64::from(step) / f64::from(steps);
            let swing = [0.0, 1.0, 0.0, -1.0][step as usize % 4] * wide;
            (from.0 + lead + part * (to.0 - from.0 - 2.0 * lead), from.1 - swing)
        };
        let inner = (0..=steps).map(along);
        let all: Vec<Place> = [from].into_iter().chain(inner).chain([to]).collect();
        for pair in all.windows(2) {
            self.line(pair[0], pair[1], Part::Spring);
        }
    }

    fn dashpot(&mut self, from: Place, to: Place, wide: f64, (rod, cylinder): (f64, f64)) {
        let part = Part::Damper;
        let y = from.1;
        if self.glyphs != GlyphSet::Braille {
            let row = self.row(y);
            let columns = [from.0, cylinder, rod, to.0].map(|x| self.column(x));
            let [Some(first), Some(cylinder), Some(rod), Some(end)] = columns else { return };
            for column in first..end {
                let character = match column {
                    _ if column == cylinder => '[',
                    _ if column == rod => ']',
                    _ if column > cylinder && column > rod => '=',
                    _ => '-',
                };
                self.put(column, row, character, part);
            }
            return;
        }
        self.line(from, (rod, y), part);
        self.line((rod, y - 0.6 * wide), (rod, y + 0.6 * wide), part);
        for side in [-wide, wide] {
            self.line((cylinder, y + side), (to.0, y + side), part);
        }
    }

    /// Draws a straight line of dots.
    fn line(&mut self, from: Place, to: Place, part: Part) {
        let length = (to.0 - from.0).abs().max((to.1 - from.1).abs()).ceil().clamp(1.0, 1e4);
        let steps = dot(length, 10_000).max(1);
        for step in 0..=steps {
            let fraction = step as f64 / steps as f64;
            let at = (from.0 + fraction * (to.0 - from.0), from.1 + fraction * (to.1 - from.1));
            if let (Some(x), Some(y)) = (whole(at.0, self.size.0), whole(at.1, self.size.1)) {
                self.set(x, y, part);
            }
        }
    }

    fn set(&mut self, column: usize, row: usize, part: Part) {
        if column < self.size.0 && row < self.size.1 {
            self.parts[row * self.size.0 + column] = Some(part);
        }
    }

    fn is_free(&self, column: usize, row: usize) -> bool {
        self.parts[row * self.size.0 + column].is_none()
    }

    fn put(&mut self, column: u16, row: u16, character: char, part: Part) {
        if column < self.cells.0 && row < self.cells.1 {
            let index = usize::from(row) * usize::from(self.cells.0) + usize::from(column);
            self.drawn[index] = Some((character, part));
        }
    }

    /// Returns the column of cells of a horizontal position in dots, up to one after the last.
    fn column(&self, x: f64) -> Option<u16> {
        let across = f64::from(self.glyphs.dots().0);
        let column = (x / across).floor();
        (column >= 0.0).then(|| dot(column, usize::from(self.cells.0)))?.try_into().ok()
    }

    fn row(&self, y: f64) -> u16 {
        let down = f64::from(self.glyphs.dots().1);
        let last = usize::from(self.cells.1.saturating_sub(1));
        u16::try_from(dot((y / down).floor(), last)).unwrap_or(0)
    }

    /// Iterates over the dots of a cell: their indices in it, and their bodies.
    fn dots(&self, column: u16, row: u16) -> impl Iterator<Item = (usize, Option<Part>)> + '_ {
        let (across, down) = self.glyphs.dots();
        let (across, down) = (usize::from(across), usize::from(down));
        let (left, top) = (usize::from(column) * across, usize::from(row) * down);
        (0..across * down).map(move |at| {
            let (x, y) = (left + at % across, top + at / across);
            (at, self.parts[y * self.size.0 + x])
        })
    }

    /// Returns the character of a cell without its own character.
    fn cell(&self, column: u16, row: u16) -> Option<(char, Part)> {
        let owner =
            self.dots(column, row).filter_map(|(_, part)| part).max_by_key(|part| *part as u8)?;
        let character = match self.glyphs {
            GlyphSet::Ascii => match owner {
                Part::Projectile => '#',
                Part::Plug => '@',
                Part::Stop => '%',
                Part::Behind => '.',
                _ => ':',
            },
            GlyphSet::Block => self.block(column, row, owner),
            GlyphSet::Braille => {
                let bits = self
                    .dots(column, row)
                    .filter(|(at, part)| self.is_seen(column, row, *at, *part));
                let bits = bits.fold(0, |bits, (at, _)| bits | BRAILLE[at]);
                if bits == 0 {
                    return None;
                }
                char::from_u32(0x2800 + u32::from(bits)).unwrap_or(' ')
            }
        };
        Some((character, owner))
    }

    fn block(&self, column: u16, row: u16, owner: Part) -> char {
        if matches!(owner, Part::Plate | Part::Behind) {
            return '░';
        }
        let solid = |part: Option<Part>| {
            part.is_some_and(|part| !matches!(part, Part::Plate | Part::Behind))
        };
        let rows: Vec<bool> = self.dots(column, row).map(|(_, part)| solid(part)).collect();
        match rows[..] {
            [true, false] => '▀',
            [false, true] => '▄',
            _ => '█',
        }
    }

    /// Returns `true` if a dot is drawn: edges and a hatch for plates, all dots for other bodies.
    fn is_seen(&self, column: u16, row: u16, at: usize, part: Option<Part>) -> bool {
        let Some(part) = part else { return false };
        if !matches!(part, Part::Plate | Part::Behind) {
            return true;
        }
        let (x, y) = (usize::from(column) * 2 + at % 2, usize::from(row) * 4 + at / 2);
        let other = |dx: usize, dy: usize| {
            // The plate continues beyond the picture.
            let (x, y) = ((x + dx).checked_sub(1), (y + dy).checked_sub(1));
            let (Some(x), Some(y)) = (x, y) else { return false };
            x < self.size.0 && y < self.size.1 && self.parts[y * self.size.0 + x] != Some(part)
        };
        let is_edge = other(0, 1) || other(2, 1) || other(1, 0) || other(1, 2);
        is_edge || (part == Part::Plate && y % 4 == 1 && (x + y / 2).is_multiple_of(4))
    }
}

/// Returns the first dot whose centre is at or after a position, up to one after the last.
fn dot(place: f64, count: usize) -> usize {
    if place <= 0.0 { 0 } else { whole_below(place.ceil(), count).unwrap_or(count) }
}

/// Returns the dot that contains a position; `None` outside the picture.
fn whole(place: f64, count: usize) -> Option<usize> {
    whole_below(place, count)
}
