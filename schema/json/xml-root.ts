/** What may stand before the first element: white space, the declaration, instructions, comments and the type of the document. */
const PROLOG = /\s{1,100}|<\?[\s\S]*?\?>|<!--[\s\S]*?-->|<!DOCTYPE[^>[]*>/iy;

/** What git puts around a first element that it could not merge. */
const MARKER = /<{7,}[^\n]*\n/y;

const NAME = /<([a-z][\w:.-]*)/iy;

/**
 * The name of the first element of an XML text, as it is written there, whatever stands before it.
 *
 * @param text - the text, or its beginning, as far as the element
 * @returns null if no element comes first
 */
export function xmlRoot(text: string): string | null {
  let at = text.startsWith('\ufeff') ? 1 : 0;
  for (;;) {
    const skipped = [PROLOG, MARKER].find((pattern) => {
      pattern.lastIndex = at;
      return pattern.test(text);
    });
    if (skipped === undefined) break;
    at = skipped.lastIndex;
  }
  NAME.lastIndex = at;
  return NAME.exec(text)?.[1] ?? null;
}
