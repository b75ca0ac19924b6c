import type { Editor } from '../core/context/index.ts';
import { middleOf, pasteObjects, readClipping } from '../core/document/index.ts';
import { isPlayText } from '../core/shelf/index.ts';
import type { ObjectChanges } from './object-changes.ts';
import type { Point, View } from './view.ts';

/** offset of copies from their originals, px */
export const BESIDE = 32;

/**
 * Pastes objects, or opens a play that was copied as text.
 * @param at the middle of what is pasted; null: at its old place if that is visible, else in the middle of the view
 */
export async function paste(
  { notices, commands }: Pick<Editor, 'notices' | 'commands'>,
  { add }: Pick<ObjectChanges, 'add'>,
  view: View,
  at: Point | null,
): Promise<void> {
  let text: string;
  try {
    text = await navigator.clipboard.readText();
  } catch {
    notices.show('warning', 'The browser does not let this page read the clipboard.', { topic: 'clipboard' });
    return;
  }
  if (isPlayText(text)) {
    commands.run('plays.paste');
    return;
  }
  const reading = readClipping(text);
  if (!reading.ok) {
    notices.show('warning', `${reading.refusal.message}. ${reading.refusal.hint}`, { topic: 'clipboard' });
    return;
  }
  const middle = middleOf(reading.clipping);
  const to = at ?? { x: view.x, y: view.y };
  const seen =
    Math.abs(middle.x - view.x) * view.zoom < view.width / 2 && Math.abs(middle.y - view.y) * view.zoom < view.height / 2;
  const move =
    at === null && seen ? { x: BESIDE, y: BESIDE } : { x: Math.round(to.x - middle.x), y: Math.round(to.y - middle.y) };
  add(`Paste ${reading.count}`, pasteObjects(reading.clipping, move.x, move.y));
}
