// Texts of src/texts/ that forms alone say: a page to look at a finished run in has no forms, and goes without them.

export const textsOfForms = ["data", "machine", "teach", "variants"];
