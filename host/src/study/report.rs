//! `rta report`: error against run time, as work-precision diagrams, tables and a page.
//!
//! | step | where |
//! | --- | --- |
//! | what is varied | [`setting`] |
//! | all depths and cut-offs from one walk of the ray tree | [`contributions`] |
//! | a scene in one format, traced on a part of its pixels | [`mod@bench`] |
//! | differences of pictures, and the Pareto front | [`measure`] |
//! | the error of a device's colour table | [`display`] |
//! | instructions under valgrind | [`instructions`] |
//! | errors and costs of every setting of a scene | [`mod@study`] |
//! | rays that are spread: samplers, lamps, antialiasing, splitting | [`mod@spreading`] |
//! | light that goes round: ambient light, radiosity, two passes, distributed rays, paths | [`mod@light`] |
//! | what one cone over each pixel gets wrong | [`crate::study::cones`] |
//! | the files | [`table`], [`diagram`], [`page`] |

use core::iter;
use std::path::{Path, PathBuf};

use rta_scenes::{Reading, shipped};

use crate::args::ReportArgs;
use crate::engine::interrupt;
use crate::engine::progress::Progress;
use crate::picture::device::Device;
use crate::picture::error::PictureError;
use crate::picture::file::Caption;
use crate::picture::output::{self, Failure, Inputs, Output};
use crate::request::scene_file::SceneFile;
use crate::study::cones;
use crate::study::error::StudyError;
use crate::study::plot;

pub mod bench;
pub mod contributions;
pub mod diagram;
pub mod display;
pub mod instructions;
pub mod light;
pub mod measure;
pub mod page;
pub mod setting;
pub mod spreading;
pub mod study;
pub mod table;

use spreading::Spread;
use study::{STEPS, Setup, Study, study};

/// A scene with the text that it was read from, and a name that no other scene of the report has.
#[derive(Clone, Debug)]
pub struct Source {
    /// The scene.
    pub scene: SceneFile,
    /// The scene file.
    pub text: Vec<u8>,
    /// Stem of its diagrams' names.
    pub title: String,
}

/// Runs `rta report`. The files are written once everything is measured.
///
/// # Errors
/// All of [`StudyError`].
pub fn run(args: &ReportArgs) -> Result<(), StudyError> {
    if args.light {
        return light::run(args);
    }
    let (size, device) = (args.size.unwrap_or(Device::Vga.size()), Device::Vga);
    if size.width() > device.size().width() || size.height() > device.size().height() {
        return Err(PictureError::LargerThanDevice { size, device }.into());
    }
    let program = std::env::current_exe().ok();
    let sources = sources(&args.scenes)?;
    let mut spread: Vec<_> = sources.iter().filter(|source| source.spreads()).cloned().collect();
    if args.scenes.is_empty() {
        spread.extend(shipped_spread()?);
    }
    output::make_folder(&args.output)?;
    let setup = Setup {
        size,
        aspect: args.aspect.map_or(Device::Vga.aspect(), |aspect| aspect.ratio()),
        program: if args.no_instructions { None } else { program.as_deref() },
        stop: interrupt::watch(),
    };
    let files = Files::open(&args.output, &sources)?;
    let studied = studies(&sources, setup)?;
    let mut progress = Progress::new(u32::try_from(spread.len()).unwrap_or(u32::MAX));
    let spread = (1..).zip(&spread).map(|(done, source)| {
        let studied = spreading::study(source, setup);
        progress.reached(done);
        studied
    });
    let spread = spread.collect::<Result<Vec<_>, _>>()?;
    // Its scenes are its own.
    let cones = args.scenes.is_empty().then(|| cones::study(setup.stop)).transpose()?;
    files.write(&studied, &spread, cones.as_ref(), setup)
}

impl Source {
    /// Returns the Cornell box, which is part of the program.
    ///
    /// # Errors
    /// [`RequestError::Scene`](crate::request::error::RequestError::Scene) if it is malformed.
    pub fn cornell() -> Result<Self, StudyError> {
        Self::of_program(("cornell", shipped::CORNELL))
    }

    /// Returns the scenes of the program with soft shadows and with a lens.
    ///
    /// # Errors
    /// [`RequestError::Scene`](crate::request::error::RequestError::Scene) if one is malformed.
    pub fn soft() -> Result<Vec<Self>, StudyError> {
        let soft = shipped::SPREADING.into_iter().filter(|(title, _)| ["penumbra", "lens"].contains(title));
        soft.map(Self::of_program).collect()
    }

    fn of_program((title, text): (&str, &str)) -> Result<Self, StudyError> {
        let scene = SceneFile::of_text(title, text, Reading::default())?;
        Ok(Self { scene, text: text.as_bytes().to_vec(), title: title.to_owned() })
    }

    /// Returns whether rays of the scene can be spread over more than the pixel.
    #[must_use]
    pub fn spreads(&self) -> bool {
        spreading::spreads(&self.scene.description)
    }
}

/// Returns the scenes of the program that are small and whose rays spread, each in one way.
fn shipped_spread() -> Result<Vec<Source>, StudyError> {
    shipped::SPREADING.into_iter().map(Source::of_program).collect()
}

/// Reads the scenes, or takes the thesis's three if no file is named.
pub(in crate::study) fn sources(paths: &[PathBuf]) -> Result<Vec<Source>, StudyError> {
    let mut sources: Vec<Source> = Vec::new();
    let scenes: Vec<_> = if paths.is_empty() {
        SceneFile::shipped()?
    } else {
        paths.iter().map(|path| SceneFile::open_with_text(path)).collect::<Result<_, _>>()?
    };
    for (scene, text) in scenes {
        let numbered = (2..).map(|number| format!("{}-{number}", scene.title));
        let mut titles = iter::once(scene.title.clone()).chain(numbered);
        let is_free = |title: &String| sources.iter().all(|other| other.title != *title);
        let title = titles.find(is_free).unwrap_or_default();
        sources.push(Source { scene, text, title });
    }
    Ok(sources)
}

/// Returns the studies of all scenes.
///
/// # Errors
/// Those of [`study::study`].
pub fn studies(sources: &[Source], setup: Setup) -> Result<Vec<Study>, StudyError> {
    let scenes = u32::try_from(sources.len()).unwrap_or(u32::MAX);
    let mut progress = Progress::new(scenes.saturating_mul(STEPS));
    let begins = (0..).step_by(STEPS as usize);
    sources.iter().zip(begins).map(|(source, done)| study(source, setup, &mut progress, done)).collect()
}

/// The files of a report, each found to be writable and none of the scenes.
struct Files {
    csv: Output,
    /// The pictures whose rays are spread.
    spreading: Output,
    /// SVG and PNG of each scene.
    diagrams: Vec<[Output; 2]>,
    page: Output,
}

impl Files {
    fn open(folder: &Path, sources: &[Source]) -> Result<Self, PictureError> {
        let mut inputs = Inputs::default();
        sources.iter().for_each(|source| inputs.add(&source.scene.inputs));
        let open = |name: &str| Output::open(&folder.join(name), &inputs);
        let diagrams = sources
            .iter()
            .map(|Source { title, .. }| Ok([open(&format!("{title}.svg"))?, open(&format!("{title}.png"))?]));
        let diagrams = diagrams.collect::<Result<_, PictureError>>()?;
        let (csv, spreading) = (open("report.csv")?, open("spreading.csv")?);
        Ok(Self { csv, spreading, diagrams, page: open("report.md")? })
    }

    fn write(
        self,
        studies: &[Study],
        spread: &[Spread],
        cones: Option<&cones::Study>,
        setup: Setup,
    ) -> Result<(), StudyError> {
        self.csv.write(&table::csv(studies).map_err(StudyError::report)?)?;
        self.spreading.write(&spreading::page::csv(spread).map_err(StudyError::report)?)?;
        for (study, [svg, png]) in studies.iter().zip(self.diagrams) {
            svg.write(diagram::svg(study).map_err(StudyError::report)?.as_bytes())?;
            let settings = "error against run time".to_owned();
            let diagram = plot::displayed(study).map_err(StudyError::report)?;
            let caption = Caption { title: study.title.clone(), settings };
            png.fill(|out| Ok::<_, Failure<StudyError>>(diagram.write_png(&caption, out)?))?;
        }
        let mut page = page::markdown(studies, setup.size, setup.aspect);
        spreading::page::markdown(&mut page, spread);
        if let Some(cones) = cones {
            cones::page::markdown(&mut page, cones);
        }
        Ok(self.page.write(page.as_bytes())?)
    }
}
