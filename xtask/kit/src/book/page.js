// The table of contents opens by the keyboard too.
document.getElementById('mdbook-sidebar-toggle')?.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    event.currentTarget.click();
});

// A list within a list stands in an item of it, also where a level of headings is left out.
addEventListener('DOMContentLoaded', () => {
    for (const list of document.querySelectorAll('.on-this-page ol > ol')) {
        const item = document.createElement('li');
        list.replaceWith(item);
        item.append(list);
    }
});
