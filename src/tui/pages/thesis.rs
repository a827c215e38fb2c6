//! Thesis tab: reproduced results, design principles, screening of concepts.

pub mod state;

use crate::tui::pages::explore;
use crate::tui::pages::explore::cursor::chart_kind;
use crate::tui::pages::explore::plan::is_corrected_figure;
use crate::tui::pages::explore::state::ChartKind;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run;
use crate::tui::preset::ReferencePreset;
use crate::worker::studies::Claims;
use cmra_studies::report::table::grid;
use cmra_studies::report::{measured as limits, thesis};
use cmra_studies::study::measured::{errors, left_out};
use cmra_studies::study::principles::{self, Concept, FUNCTIONS, Principle};
use cmra_studies::study::thesis::{ClaimVerdict, Row, tally};

pub use state::{CLAIMS, CONCEPTS, MEASURED, PRINCIPLES};

/// Minimum width for the detail beside the list, and maximum rows of the detail below it.
const BESIDE: u16 = 110;
const DETAIL: u16 = 11;
/// Maximum columns of a claim's reference in the list; a third of a narrow list.
const PLACE: u16 = 25;
const LABEL: u16 = 12;

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: CLAIMS, label: "Claims", keys: &[
        key(A::Down, "claim", "select another claim"),
        key(A::Enter, "open", "load the preset that shows the claim"),
    ] },
    PaneSpec { pane: PRINCIPLES, label: "Principles", keys: &[
        key(A::Down, "principle", "select another principle"),
        key(A::Enter, "open", "load the preset that shows the principle"),
    ] },
    PaneSpec { pane: CONCEPTS, label: "Concepts", keys: &[] },
    PaneSpec { pane: MEASURED, label: "Measurements", keys: &[] },
];

const PAGES: &[PageSpec] = &[
    PageSpec { name: "Claims", panes: &[CLAIMS] },
    PageSpec { name: "Principles", panes: &[PRINCIPLES] },
    PageSpec { name: "Concepts", panes: &[CONCEPTS] },
    PageSpec { name: "Measurements", panes: &[MEASURED] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Thesis)), "Thesis tab", "reproduce"),
    Command::new(CommandTarget::Show(CLAIMS, None), "Claims", "reproduce thesis check verdict"),
    Command::new(CommandTarget::Show(PRINCIPLES, None), "Principles", "families functions"),
    Command::new(CommandTarget::Show(MEASURED, None), "Measured limits", "validate validation measurements class bias scatter"),
    Command::new(CommandTarget::Show(CONCEPTS, None), "Concepts", "screening matrix weights criteria ratings"),
];

pub(crate) struct ThesisTab;

impl Page for ThesisTab {
    fn about(&self) -> About {
        About { pages: PAGES, panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        let lacks = app.jobs.lacks::<Claims, _>(&app.pages.thesis.report, &Scene::default());
        if lacks && app.pane() == CLAIMS {
            jobs::look_at(app, jobs::LOOK, &Arc::default(), Claims);
        }
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match (app.pane(), action) {
            // The claims do not depend on the scene.
            (CLAIMS, Action::Run) => jobs::study_of(app, action, &Arc::default(), Claims),
            (CLAIMS, Action::Enter) => {
                open(app, app.pages.thesis.claim().and_then(|row| row.claim.preset));
            }
            (PRINCIPLES, Action::Enter) => open(app, Some(principle(app).preset)),
            _ => return false,
        }
        true
    }

    fn is_of_use(&self, app: &App, action: Action) -> bool {
        let shows_it = || app.pages.thesis.claim().is_some_and(|row| row.claim.preset.is_some());
        (app.pane(), action) != (CLAIMS, Action::Enter) || shows_it()
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        if app.pane() == PRINCIPLES {
            let Principle { section, preset, .. } = principle(app);
            return note(Some(format!("section {section}: <enter> opens {preset}")));
        }
        let claim = app.pages.thesis.claim().filter(|_| app.pane() == CLAIMS)?.claim;
        let opens = match claim.preset {
            Some(name) => format!("<enter> opens {name}"),
            None => "no preset shows this".to_owned(),
        };
        // The detail shows the cause. A line that changes its height here would move the list.
        note(Some(format!("{} {}: {opens}", claim.verdict.letter(), claim.verdict.words())))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.thesis;
        // The other pages show what stands in the thesis, without a computation.
        if app.pane() != CLAIMS {
            return Vec::new();
        }
        let mut parts = Vec::new();
        let words = |it: &Running| format!("checking the claims{}", it.counted("of", ""));
        let checking = progress::<Claims, _>(app, &tab.report, &Scene::default(), words, "claims");
        parts.extend(checking);
        if tab.report.result.is_some() {
            let counts = ClaimVerdict::ALL.iter().zip(tally(tab.rows()));
            let counts: Vec<String> =
                counts.map(|(verdict, count)| format!("{count} {}", verdict.words())).collect();
            parts.push(part(Severity::Note, counts.join(", ")));
        }
        parts
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        app.pages.thesis.report.keep(running, news);
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let tab = &app.pages.thesis;
        let (file, reach, text) = match app.pane() {
            PRINCIPLES => ("principles", Reach::Complete, thesis::principles().csv()),
            CONCEPTS => ("concepts", Reach::Complete, thesis::concepts().csv()),
            MEASURED => ("measured-limits", Reach::Complete, limits::rows(left_out()).csv()),
            _ => {
                // The table contains the displayed claims that are already checked.
                let shown: Vec<Row> = app.pages.thesis.rows().to_vec();
                let reach = tab.report.reach;
                let text = || thesis::claims(&shown).with_reach(reach).csv();
                let text = (!shown.is_empty()).then(text)?;
                ("claims", reach, text)
            }
        };
        Some(PageTable::new("Export this page to CSV", file, reach, move |_| text.clone()))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let (tab, shown) = (&app.pages.thesis, app.list_rows());
        match app.pane() {
            CLAIMS => Some(Rows { count: tab.rows().len(), selected: tab.selected_row(), shown }),
            PRINCIPLES => {
                Some(Rows { count: principles::PRINCIPLES.len(), selected: tab.principle, shown })
            }
            _ => None,
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        let is_principle = app.pane() == PRINCIPLES;
        let tab = &mut app.pages.thesis;
        *(if is_principle { &mut tab.principle } else { &mut tab.selected }) = row;
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        match app.pane() {
            CLAIMS => claims(app, body, canvas),
            PRINCIPLES => principles(app, body, canvas),
            CONCEPTS => concepts(app, body, canvas),
            _ => measured(app, body, canvas),
        }
    }
}

/// Returns the selected principle.
fn principle(app: &App) -> Principle {
    principles::PRINCIPLES[app.pages.thesis.principle.min(principles::PRINCIPLES.len() - 1)]
}

/// Opens the preset of the selected row: a sweep in Explore, another scene in the Run tab.
fn open(app: &mut App, preset: Option<&str>) {
    let entry = app.files.presets.iter().find(|entry| Some(entry.name.as_str()) == preset);
    match entry.cloned() {
        Some(entry) => show(app, entry.base()),
        None => app.report_progress("no preset shows this"),
    }
}

/// Loads a scene and shows its subject: a sweep in Explore, else its run.
pub(crate) fn show(app: &mut App, base: ReferencePreset) {
    let (name, axes) = (base.name.clone(), axes(&base.scene));
    let picture = picture_of(app, &base);
    edit::load(app, base, picture);
    look(app);
    if axes > 0 {
        app.report_progress(format!("{name} loaded, here is its sweep (<undo> undoes)"));
    }
}

/// Returns the number of axes of a scene's sweep.
pub(crate) fn axes(scene: &Scene) -> usize {
    scene.sweep.as_ref().map_or(0, |sweep| sweep.axes.len())
}

/// Returns the display for the sweep of a preset: a map for two axes, but curves for figures of the thesis, which include the printed
/// scheme.
fn picture_of(app: &App, base: &ReferencePreset) -> ChartKind {
    match axes(&base.scene) {
        0 => chart_kind(app),
        2.. if !is_corrected_figure(base) => ChartKind::Surface,
        _ => ChartKind::Line,
    }
}

/// Shows the subject of the scene as if its preset had been loaded.
pub(crate) fn begin(app: &mut App) {
    app.pages.explore.picture = picture_of(app, &app.base);
    look(app);
}

/// Shows the subject of the scene: a sweep in Explore, else its run.
fn look(app: &mut App) {
    if axes(&app.scene) == 0 {
        app.focus_on(run::VARIABLES);
        return;
    }
    app.focus_on(explore::RESULTS);
    app.pages.explore.output = 0;
    app.pages.explore.cursor = None;
    explore::ExploreTab.enter(app);
}

fn role(verdict: ClaimVerdict) -> Role {
    match verdict {
        ClaimVerdict::Reproduced => Role::Text,
        ClaimVerdict::Corrected | ClaimVerdict::Misprint => Role::Warning,
        ClaimVerdict::NotReproduced => Role::Error,
    }
}

fn claims(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.thesis;
    let (list, detail) = if area.width >= BESIDE {
        split_left(area, area.width * 11 / 20)
    } else {
        split_bottom(area, DETAIL.min(area.height / 2))
    };
    let shown = tab.rows();
    let pane = PaneFrame::new("Claims of the thesis")
        .right(shown.len().to_string())
        .focused(app.dialog.is_none());
    let inner = pane.draw(list, canvas);
    if shown.is_empty() {
        let text = nothing::<Claims>(app, "checking the first claims", None);
        canvas.put(inner, (1, 1), &text, Role::Dim);
    }
    let says = PLACE.min(inner.width / 3);
    // A claim takes as many lines as necessary.
    let room = usize::from(inner.width.saturating_sub(says));
    let lines: Vec<(usize, bool, String)> = shown
        .iter()
        .enumerate()
        .flat_map(|(index, row)| {
            let parts = wrap(row.claim.says, room).into_iter().enumerate();
            parts.map(move |(at, part)| (index, at == 0, part))
        })
        .collect();
    let selected = lines.iter().position(|line| line.0 == tab.selected_row()).unwrap_or(0);
    let rows = RowList { count: lines.len(), selected, painted: false };
    // The first line in view is the first one of its claim.
    let cut = lines.iter().skip(rows.first(inner.height)).take_while(|line| !line.1).count();
    let begin = (rows.first(inner.height) + cut).min(selected);
    let lines = &lines[begin..];
    let rows = RowList { count: lines.len(), selected: selected - begin, painted: false };
    let target = |line: usize| Some(Target::Row(CLAIMS, lines[line].0));
    rows.render(canvas, inner, target, |canvas, line, at| {
        let (index, is_first, part) = &lines[at];
        let row = &shown[*index];
        let role = role(row.claim.verdict);
        if *is_first {
            canvas.put(line, (0, 0), &row.claim.verdict.letter().to_string(), role);
            let place = clip(row.claim.place, usize::from(says.saturating_sub(3)));
            canvas.put(line, (2, 0), &place, role);
        }
        canvas.put(line, (says, 0), part, role);
        if *index == tab.selected_row() && app.dialog.is_none() {
            canvas.paint_row(line);
        }
    });
    claim(app, detail, canvas);
}

/// Draws the selected claim in full, one part below the other.
fn claim(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let place = app.pages.thesis.claim().map_or("", |row| row.claim.place);
    let hint = app.keymap.shown("<next-pane>: principles");
    let inner = PaneFrame::new(place).right(hint).draw(area, canvas);
    let Some(row) = app.pages.thesis.claim() else { return };
    let verdict = format!("{} {}", row.claim.verdict.letter(), row.claim.verdict.words());
    let texts = [
        ("says", row.claim.says),
        ("computed", &row.computed),
        ("as printed", &row.as_printed),
        ("verdict", &verdict),
        ("cause", row.claim.cause),
    ];
    let mut y = 0;
    for (label, text) in texts.into_iter().filter(|(_, text)| !text.is_empty()) {
        canvas.put(inner, (0, y), label, Role::Dim);
        for line in wrap(text, usize::from(inner.width.saturating_sub(LABEL).max(8))) {
            canvas.put(inner, (LABEL, y), &line, Role::Text);
            y += 1;
        }
    }
}

/// Minimum rows of the chart of measured limits, frame included.
const CHART_LEAST: u16 = 8;

/// Meaning of the letters of [`FUNCTIONS`].
const LEGEND: &str = "O orientation, A acceleration, S stiffness, L lateral";

fn principles(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let pane = PaneFrame::new(LEGEND)
        .right(app.keymap.shown("<next-pane>: concepts"))
        .focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    let all = principles::PRINCIPLES;
    // Rows of the list: a principle by its index, or the title of its family.
    let begins = |at: usize| at == 0 || all[at - 1].family != all[at].family;
    let rows = (0..all.len()).flat_map(|at| [(at, true), (at, false)]);
    let rows: Vec<(usize, bool)> = rows.filter(|&(at, title)| !title || begins(at)).collect();
    let own = principle(app);
    let selected = rows.iter().position(|row| !row.1 && all[row.0] == own).unwrap_or(0);
    let list = RowList { count: rows.len(), selected, painted: app.dialog.is_none() };
    let target = |row: usize| (!rows[row].1).then(|| Target::Row(PRINCIPLES, rows[row].0));
    list.render(canvas, inner, target, |canvas, line, row| {
        let (at, is_title) = rows[row];
        if is_title {
            canvas.put(line, (0, 0), all[at].family, Role::Title);
            return;
        }
        canvas.put(line, (1, 0), all[at].name, Role::Text);
        for (column, (letter, function)) in (47..).step_by(3).zip(FUNCTIONS) {
            if all[at].functions.contains(&function) {
                canvas.put(line, (column, 0), &letter.to_string(), Role::Text);
            }
        }
    });
    let below = (u16::try_from(rows.len()).unwrap_or(u16::MAX)..inner.height).skip(1);
    for (y, line) in below.zip(wrap(own.idea, usize::from(inner.width.saturating_sub(1)))) {
        canvas.put(inner, (1, y), &line, Role::Dim);
    }
}

fn concepts(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let pane = PaneFrame::new("Ratings of the concepts, 3 is the reference (Table 7.1)")
        .right(app.keymap.shown("<next-pane>: measurements"))
        .focused(app.dialog.is_none());
    let inner = pane.draw(area, canvas);
    // A narrow screen shortens the names of the criteria.
    let (name, cell) = if inner.width < 78 { (11, 5) } else { (22, 6) };
    let put = |canvas: &mut Canvas<'_>, y: u16, label: &str, weight: &str, cells: [String; 8]| {
        canvas.put(inner, (0, y), &clip(label, usize::from(name) - 1), Role::Text);
        canvas.put(inner, (name, y), weight, Role::Text);
        for (column, text) in (name + 7..).step_by(cell).zip(cells) {
            canvas.put(inner, (column, y), &text, Role::Text);
        }
    };
    put(canvas, 0, "criterion", "weight", principles::CONCEPTS.map(|it| initials(it.name)));
    for (y, (at, (criterion, weight))) in (1..).zip(principles::CRITERIA.iter().enumerate()) {
        let ratings = principles::CONCEPTS.map(|it| significant(it.ratings[at], 2));
        put(canvas, y, criterion, &format!("{weight:>3} %"), ratings);
    }
    put(canvas, 8, "total", "", principles::CONCEPTS.map(|it| format!("{:.2}", it.total)));
    put(canvas, 9, "rank", "", principles::CONCEPTS.map(|it| it.rank.to_string()));
    let letters = |it: Concept| {
        FUNCTIONS.iter().filter(|row| it.functions.contains(&row.1)).map(|row| row.0).collect()
    };
    put(canvas, 10, "functions", "", principles::CONCEPTS.map(letters));
    canvas.put(inner, (0, 11), LEGEND, Role::Dim);
    let half = principles::CONCEPTS.len() / 2;
    for (at, it) in principles::CONCEPTS.iter().enumerate() {
        let (column, row) = if at < half { (0, at) } else { (inner.width / 2, at - half) };
        let line = format!("{}  {}", initials(it.name), it.name);
        canvas.put(inner, (column, 12 + u16::try_from(row).unwrap_or(u16::MAX)), &line, Role::Dim);
    }
}

/// Draws measured limits and the limits expected from all other papers: the chart, and the errors by class.
fn measured(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let rows = left_out();
    let table = grid(&limits::error_cells(&errors(rows)), usize::from(area.width.max(80) - 2));
    let lines: Vec<&str> = table.lines().collect();
    let height = u16::try_from(lines.len() + 2).unwrap_or(u16::MAX);
    let (above, below) = split_bottom(area, height.min(area.height.saturating_sub(CHART_LEAST)));
    if let Some(mut chart) = limits::picture(rows) {
        chart.focused = app.dialog.is_none();
        canvas.draw(&chart, above);
    }
    let inner = PaneFrame::new("Errors of papers left out, by class")
        .right(app.keymap.shown("<next-pane>: claims"))
        .draw(below, canvas);
    for (y, line) in (0..inner.height).zip(lines) {
        let role = if y == 0 { Role::Dim } else { Role::Text };
        canvas.put(inner, (0, y), line, role);
    }
}

/// Abbreviates a name to two letters of its first word and one of the second: `EmF` for `Emergent four-bar`.
fn initials(name: &str) -> String {
    let mut words = name.split(' ');
    let first: String = words.next().unwrap_or_default().chars().take(2).collect();
    let second: String = words.next().unwrap_or_default().chars().take(1).collect();
    first + &second.to_uppercase()
}
