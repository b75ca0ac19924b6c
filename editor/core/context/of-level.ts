import type { Editor, OpenLevel } from './editor.ts';

/**
 * Something that belongs to an open level: made on first use, closed when another level is opened.
 * @param make is called once for each opened level
 */
export function ofLevel<T extends { close(): void }>(
  make: (editor: Editor, level: OpenLevel) => T,
): (editor: Editor, level: OpenLevel) => T {
  const known = new WeakMap<OpenLevel, T>();
  return (editor, level) => {
    const there = known.get(level);
    if (there !== undefined) return there;
    const made = make(editor, level);
    known.set(level, made);
    const stop = editor.open.subscribe((current) => {
      if (current === level) return;
      stop();
      known.delete(level);
      made.close();
    });
    return made;
  };
}
