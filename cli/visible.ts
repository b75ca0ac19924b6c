const asEscape = (character: string): string => `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;

/**
 * Makes text from a file or the command line safe to print. Control characters, which could move the cursor or colour the
 * terminal, become \u escapes; so do characters that change the writing direction. Newlines and tabs stay.
 */
export function visible(text: string): string {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: control characters are what this looks for
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, asEscape);
}

/** The same, on one line. */
export function visibleLine(text: string): string {
  return visible(text).replace(/[\n\t]/g, asEscape);
}
