//! Where each pane stands: a total function of the size, without any type of the terminal library.

use super::Tab;
use super::sweep::Picture;
use crate::tui::keymap::Pane;

/// The smallest size that can be worked with: columns and rows.
pub const SMALLEST: (u16, u16) = (60, 16);

/// Least rows of a chart that can be read.
pub const CHART_ROWS: u16 = 9;
/// Below this width: the setup and what it is about get in each other's way.
const NARROW: u16 = 72;
/// Columns of a search's setup there: its longest row, `stroke at most 1.000 m`, and a frame.
const SEARCH_SETUP: u16 = 30;
/// From this width on: three stacked charts.
const WIDE: u16 = 100;
/// From this width on: names of runs in full beside their results.
const ROOMY: u16 = 120;
/// From this width on: events and energy beside the charts.
const WIDEST: u16 = 160;
/// From this height on: the table of runs is always there.
const TALL: u16 = 34;

/// A rectangle of character cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Left column.
    pub x: u16,
    /// Top row.
    pub y: u16,
    /// Columns.
    pub width: u16,
    /// Rows.
    pub height: u16,
}

impl Area {
    fn split_left(self, width: u16) -> (Self, Self) {
        let width = width.min(self.width);
        let right = Self { x: self.x + width, width: self.width - width, ..self };
        (Self { width, ..self }, right)
    }

    fn split_bottom(self, height: u16) -> (Self, Self) {
        let height = height.min(self.height);
        let bottom = Self { y: self.y + self.height - height, height, ..self };
        let top = Self { height: self.height - height, ..self };
        (top, bottom)
    }
}

/// Where everything stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Tabs, preset, auto-run.
    pub title: Area,
    /// The panes.
    pub body: Body,
    /// The newest message, or the readout.
    pub message: Area,
    /// State of the run.
    pub status: Area,
    /// Keys that work here.
    pub keys: Area,
    /// The names of the tab's pages, where it has several.
    pub pages: Option<Area>,
}

/// What a layout depends on.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Columns and rows.
    pub size: (u16, u16),
    /// The tab shown.
    pub tab: Tab,
    /// The pane that has the keys.
    pub focus: Pane,
    /// That pane fills the body.
    pub full_pane: bool,
    /// The tab has several pages: their names take a row.
    pub has_pages: bool,
    /// Pinned runs.
    pub pins: usize,
    /// What Explore shows.
    pub picture: Picture,
}

/// What stands between title row and message row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Body {
    /// Nothing fits.
    TooSmall,
    /// The Run tab.
    Run(Panes),
    /// The Explore tab.
    Explore(SweepPanes),
    /// Accuracy.
    Accuracy(AccuracyPanes),
    /// Stability: the map or the stiff scenes.
    Stability(Area),
    /// The Log tab.
    Log(Area),
    /// The Thesis tab.
    Thesis(Area),
    /// The Limit tab.
    Limit(LimitPanes),
    /// The Search tab: setup, and what was found.
    Search(Area, Area),
}

/// The panes of the Limit tab: those that have room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LimitPanes {
    /// The comparison at equal areal mass.
    pub comparison: Option<Area>,
    /// The residual velocity, and the limit in words.
    pub residual: Option<Area>,
    /// The map of mass efficiency.
    pub map: Option<Area>,
}

/// The panes of the Run tab.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Panes {
    /// The list of variables.
    pub variables: Option<Area>,
    /// One chart (the selected one) or all three, from top to bottom.
    pub charts: Vec<Area>,
    /// The table of runs.
    pub runs: Option<Area>,
    /// The events of the current run.
    pub events: Option<Area>,
    /// Its energy ledger.
    pub ledger: Option<Area>,
    /// The drawing of the mechanism.
    pub mechanism: Option<Area>,
}

/// The panes of the Explore tab.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SweepPanes {
    /// Axes, output, held variables.
    pub setup: Option<Area>,
    /// One chart or two, or the map.
    pub plots: Vec<Area>,
    /// The scale of the map.
    pub scale: Option<Area>,
    /// The slices through the cursor, along and up.
    pub slices: Vec<Area>,
}

/// The panes of the Accuracy tab.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AccuracyPanes {
    /// Error against run time.
    pub chart: Area,
    /// The methods, and what is to be said of the selected one.
    pub methods: Area,
    /// What some accuracies cost here.
    pub answers: Area,
}

impl Layout {
    /// Columns of a chart that stand for time.
    pub fn chart_columns(&self) -> u16 {
        match &self.body {
            Body::Run(panes) => {
                panes.charts.first().map_or(40, |area| area.width.saturating_sub(12))
            }
            Body::Accuracy(panes) => panes.chart.width.saturating_sub(12),
            Body::TooSmall
            | Body::Explore(_)
            | Body::Stability(_)
            | Body::Log(_)
            | Body::Thesis(_)
            | Body::Limit(_)
            | Body::Search(..) => 40,
        }
    }

    /// Rows of the list of variables.
    pub fn variable_rows(&self) -> usize {
        match &self.body {
            Body::Run(panes) => {
                panes.variables.map_or(10, |area| usize::from(area.height.saturating_sub(3)))
            }
            Body::TooSmall
            | Body::Explore(_)
            | Body::Accuracy(_)
            | Body::Stability(_)
            | Body::Log(_)
            | Body::Thesis(_)
            | Body::Limit(_)
            | Body::Search(..) => 10,
        }
    }

    /// Rows of the Log tab.
    pub fn log_rows(&self) -> usize {
        match &self.body {
            Body::Log(area) | Body::Stability(area) | Body::Thesis(area) => {
                usize::from(area.height.saturating_sub(2))
            }
            Body::Explore(panes) => {
                panes.setup.map_or(10, |area| usize::from(area.height.saturating_sub(2)))
            }
            Body::Search(setup, _) => usize::from(setup.height.saturating_sub(2)),
            Body::TooSmall | Body::Run(_) | Body::Accuracy(_) | Body::Limit(_) => 10,
        }
    }
}

/// From this height on the names of the pages have a row.
pub const WITH_PAGES: u16 = 18;

/// Rows for messages: always the same number, so that the panes never move; two from this height on.
pub const MESSAGE_ROWS: (u16, u16) = (1, 2);
const TWO_MESSAGE_ROWS: u16 = 20;

/// Where everything stands.
pub fn layout(wanted: &Wanted) -> Layout {
    let (width, height) = wanted.size;
    let message_rows = if height < TWO_MESSAGE_ROWS { MESSAGE_ROWS.0 } else { MESSAGE_ROWS.1 };
    let row =
        |y: u16| Area { x: 0, y: y.min(height.saturating_sub(1)), width, height: height.min(1) };
    let all =
        Area { x: 0, y: height.min(1), width, height: height.saturating_sub(3 + message_rows) };
    let (pages, body) = if wanted.has_pages && all.height > 1 {
        let body = Area { y: all.y + 1, height: all.height - 1, ..all };
        (Some(Area { height: 1, ..all }), body)
    } else {
        (None, all)
    };
    let body = if width < SMALLEST.0 || height < SMALLEST.1 {
        Body::TooSmall
    } else {
        parts(wanted, body)
    };
    Layout {
        title: row(0),
        body,
        pages,
        message: Area {
            height: message_rows.min(height),
            ..row(height.saturating_sub(2 + message_rows))
        },
        status: row(height.saturating_sub(2)),
        keys: row(height.saturating_sub(1)),
    }
}

fn parts(wanted: &Wanted, body: Area) -> Body {
    let Wanted { focus, full_pane, pins, size: (width, height), .. } = *wanted;
    match wanted.tab {
        Tab::Explore => Body::Explore(match wanted.picture {
            Picture::Line => lines(body, focus, full_pane),
            Picture::Surface => surface(body, focus, full_pane),
        }),
        Tab::Numerics if focus == Pane::Accuracy => Body::Accuracy(accuracy(body, full_pane)),
        Tab::Numerics => Body::Stability(body),
        Tab::Log => Body::Log(body),
        Tab::Thesis => Body::Thesis(body),
        Tab::Limit => Body::Limit(limit(body, focus, full_pane)),
        Tab::Search => {
            let width = match (full_pane, focus) {
                // Beside each other neither could be read: the one that has the keys gets the room.
                (false, Pane::SearchSetup) if body.width < NARROW => SEARCH_SETUP,
                (false, _) if body.width < NARROW => 0,
                (false, _) => setup_width(body.width),
                (true, Pane::SearchSetup) => body.width,
                (true, _) => 0,
            };
            let (setup, found) = body.split_left(width);
            Body::Search(setup, found)
        }
        Tab::Run if full_pane => Body::Run(full(body, focus)),
        Tab::Run if width < WIDE => Body::Run(narrow(body, height, focus, pins)),
        Tab::Run => Body::Run(wide(body, height, focus, pins)),
    }
}

/// The comparison above the residual velocity and the map; the pane that has the keys alone where there is no room for three.
fn limit(body: Area, focus: Pane, full_pane: bool) -> LimitPanes {
    let rows = if body.height < ROOM_FOR_FIGURES { VERDICT_ROWS } else { COMPARISON_ROWS };
    let alone = full_pane || body.height < rows + 8;
    if alone {
        let of = |pane| (focus == pane).then_some(body);
        return LimitPanes {
            comparison: of(Pane::Comparison),
            residual: of(Pane::Residual),
            map: of(Pane::EfficiencyMap),
        };
    }
    let (below, comparison) = {
        let (top, rest) = body.split_bottom(body.height - rows);
        (rest, top)
    };
    if body.width < NARROW {
        let map = focus == Pane::EfficiencyMap;
        return LimitPanes {
            comparison: Some(comparison),
            residual: (!map).then_some(below),
            map: map.then_some(below),
        };
    }
    let (left, right) = below.split_left(below.width / 2);
    LimitPanes { comparison: Some(comparison), residual: Some(left), map: Some(right) }
}

/// Rows of the comparison, frame included; of the verdict alone where the body is lower than this, so that charts can be read.
const COMPARISON_ROWS: u16 = 10;
const VERDICT_ROWS: u16 = 6;
const ROOM_FOR_FIGURES: u16 = 26;

fn full(body: Area, focus: Pane) -> Panes {
    match focus {
        Pane::Charts => Panes { charts: stacked(body), ..Panes::default() },
        Pane::Runs => Panes { runs: Some(body), ..Panes::default() },
        _ => Panes { variables: Some(body), ..Panes::default() },
    }
}

fn narrow(body: Area, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, right) = body.split_left(31);
    let mut panes = Panes { variables: Some(left), ..Panes::default() };
    if height >= TALL {
        let (top, bottom) = right.split_bottom(runs_height(pins));
        panes.runs = Some(bottom);
        panes.charts = if top.height >= 36 { stacked(top) } else { vec![top] };
    } else if focus == Pane::Runs {
        panes.runs = Some(right);
    } else {
        panes.charts = vec![right];
    }
    panes
}

fn wide(body: Area, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, mut right) = body.split_left(if body.width >= ROOMY { 52 } else { 48 });
    let mut panes = Panes::default();
    if height >= TALL || focus == Pane::Runs {
        let wanted = runs_height(pins).min(body.height / 2);
        let (top, bottom) = left.split_bottom(wanted);
        panes.variables = Some(top);
        panes.runs = Some(bottom);
    } else {
        panes.variables = Some(left);
    }
    if body.width >= WIDEST {
        let (middle, column) = right.split_left(right.width - 42);
        right = middle;
        let (events, ledger) = column.split_bottom(14.min(column.height / 2));
        panes.events = Some(events);
        panes.ledger = Some(ledger);
    }
    if right.height >= DRAWN {
        let (charts, drawing) = right.split_bottom(DRAWING_ROWS);
        right = charts;
        panes.mechanism = Some(drawing);
    }
    panes.charts = stacked(right);
    panes
}

/// Rows of the drawing of the mechanism, frame included, and from what height on it stands below the charts.
const DRAWING_ROWS: u16 = 5;
const DRAWN: u16 = 19;

/// The setup beside one chart, or two where there is room.
fn lines(body: Area, focus: Pane, full_pane: bool) -> SweepPanes {
    if full_pane && focus == Pane::ExploreSetup {
        return SweepPanes { setup: Some(body), ..SweepPanes::default() };
    }
    let (setup, rest) = if full_pane {
        (None, body)
    } else {
        let (left, right) = body.split_left(setup_width(body.width));
        (Some(left), right)
    };
    let plots = if rest.height >= 26 {
        let (top, bottom) = rest.split_bottom(rest.height / 2);
        vec![top, bottom]
    } else {
        vec![rest]
    };
    SweepPanes { setup, plots, ..SweepPanes::default() }
}

fn setup_width(width: u16) -> u16 {
    match width {
        0..NARROW => 24,
        NARROW..WIDE => 27,
        WIDE.. => 34,
    }
}

/// The map; setup at its left, scale and slices at its right. On a narrow screen the pane at the left is the one that is of
/// use: the setup while it has the keys, else scale and slices.
fn surface(body: Area, focus: Pane, full_pane: bool) -> SweepPanes {
    let on_setup = focus == Pane::ExploreSetup;
    if full_pane && on_setup {
        return SweepPanes { setup: Some(body), ..SweepPanes::default() };
    }
    if full_pane {
        return SweepPanes { plots: vec![body], ..SweepPanes::default() };
    }
    let (left, rest) = body.split_left(setup_width(body.width));
    if body.width < ROOMY && on_setup {
        return SweepPanes { setup: Some(left), plots: vec![rest], ..SweepPanes::default() };
    }
    let (setup, map, side) = if body.width < ROOMY {
        (None, rest, left)
    } else {
        let (map, side) = rest.split_left(rest.width - 32.min(rest.width));
        (Some(left), map, side)
    };
    // Ten bands and the marks, within a frame; what is left goes to the slices, one where two would be too low.
    let (scale, below) = side.split_bottom(side.height - side.height.min(13));
    let slices = match below.height {
        0..=5 => Vec::new(),
        6..=15 => vec![below],
        _ => {
            let (top, bottom) = below.split_bottom(below.height / 2);
            vec![top, bottom]
        }
    };
    SweepPanes { setup, plots: vec![map], scale: Some(scale), slices }
}

/// Rows of what `auto` uses and what two accuracies cost.
const ANSWER_ROWS: u16 = 3;

/// The chart beside the methods, or alone, and a row for each answer below.
fn accuracy(body: Area, alone: bool) -> AccuracyPanes {
    let (top, answers) = body.split_bottom(ANSWER_ROWS);
    let wanted = match body.width {
        _ if alone => 0,
        0..72 => 29,
        72..WIDE => 35,
        WIDE..116 => 54,
        116.. => 63,
    };
    let (chart, methods) = top.split_left(top.width - wanted.min(top.width));
    AccuracyPanes { chart, methods, answers }
}

/// Header, the current run, the pins, and what differs from the first pin.
fn runs_height(pins: usize) -> u16 {
    let rows = u16::try_from(pins.min(8)).unwrap_or(8);
    if rows == 0 { 6 } else { 7 + rows }
}

/// As many of the three charts as can be read: six rows each, and two more for the common axis.
fn stacked(area: Area) -> Vec<Area> {
    let count = match area.height {
        0..=13 => 1,
        14..=19 => 2,
        _ => 3,
    };
    // Short charts share the time axis of the lowest, which needs two rows more for it.
    let extra = if count > 1 && area.height / count < 11 { 2 } else { 0 };
    let each = (area.height - extra) / count;
    let mut areas = Vec::new();
    let mut y = area.y;
    for index in 0..count {
        let rest = area.y + area.height - y;
        let height = if index + 1 == count { rest } else { each };
        areas.push(Area { y, height, ..area });
        y += height;
    }
    areas
}
