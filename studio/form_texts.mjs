// Texts of src/texts/ that only forms use: a page that only shows a finished run has no forms, and omits
// them.

export const formTexts = ["data", "machine", "teach", "variants"];
