//! Generated content of this project's book besides entries: figures of the connectors, output of scenes, the worked
//! examples of an audit and of a check, and the statements of the documents.

use crate::studies::{agreement, derivatives};
use crate::{figures, museum, scene, statements, worked_check, worked_example};
use jointproof::toolkit::verify::Audit;
use judge::audited;
use kit::{Extras, Project};

/// All generated content.
pub(crate) fn all(project: &Project) -> anyhow::Result<Extras> {
    let audit = ("audit".to_owned(), audited::text(&[worked_example::run()], Audit::passed, &|_| None)?);
    Ok(Extras {
        figures: [figures::all(), scene::figures(project)?].concat(),
        moving: figures::moving(),
        outputs: [
            vec![audit, derivatives::output()?],
            worked_check::outputs()?,
            figures::outputs(),
            scene::outputs(project)?,
        ]
        .concat(),
        tables: [scene::tables(), scene::plans(project)?, agreement::tables(project)?, vec![derivatives::table()]]
            .concat(),
        texts: [statements::book::texts(project)?, vec![("museum".to_owned(), museum::chapter()?)]].concat(),
        facts: statements::book::facts(project)?,
        served: scene::served(),
    })
}
