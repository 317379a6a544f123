//! Tables in Markdown, with aligned columns.

/// A table; the first `words` columns are words and begin at the left, the others are numbers.
#[must_use]
pub fn table(head: &[&str], rows: &[Vec<String>], words: usize) -> String {
    let mut widths: Vec<usize> = head.iter().map(|name| name.chars().count()).collect();
    for row in rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let aligned = cells.zip(&widths).enumerate().map(|(at, (cell, width))| {
            if at < words { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        format!("| {} |\n", aligned.collect::<Vec<_>>().join(" | "))
    };
    let rule = widths.iter().enumerate().map(|(at, width)| {
        if at < words { "-".repeat(*width) } else { format!("{}:", "-".repeat(width.saturating_sub(1))) }
    });
    let rule: Vec<_> = rule.collect();
    let mut text = line(&mut head.iter().copied());
    text += &line(&mut rule.iter().map(String::as_str));
    for row in rows {
        text += &line(&mut row.iter().map(String::as_str));
    }
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn words_are_at_the_left_and_numbers_at_the_right() {
        let rows = [vec!["a".to_owned(), "1".to_owned()], vec!["long".to_owned(), "10000".to_owned()]];
        assert_eq!(
            super::table(&["name", "n"], &rows, 1),
            "| name |     n |\n| ---- | ----: |\n| a    |     1 |\n| long | 10000 |\n"
        );
    }
}
