import { decodePlay, playToText } from '../../../game/index.ts';
import { type LevelFile, leavingFolder, type OwnRules } from '../../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import { copyText, keepFile, LONGEST_LINK, linkTo, plainName } from '../exchange/index.ts';
import { bareTitle, PLAY_EXTENSION } from '../shelf/index.ts';
import { termsAt } from '../terms/index.ts';

/** A play to be sent. */
export interface SharedPlay {
  /** What to call it: `attempt 3`. */
  readonly title: string;
  readonly bytes: Uint8Array;
  /** The level as it was played, and the rules of its folder; null if it is not known. */
  readonly played: { readonly file: LevelFile; readonly rules: OwnRules } | null;
}

/** The name of the file that a play is saved as. @param level the name of the level */
export const playFileName = (level: string, title: string): string =>
  `${[level, bareTitle(title)].map((part) => plainName(part) || 'play').join('-')}${PLAY_EXTENSION}`;

/** Saves a play as a `.gqr` file. */
export async function savePlay(editor: Editor, level: string, { title, bytes }: SharedPlay): Promise<void> {
  const name = playFileName(level, title);
  const blob = new Blob([new Uint8Array(bytes)], { type: 'application/octet-stream' });
  if (await keepFile({ name, blob })) editor.notices.show('info', `${name} was saved.`, { topic: 'plays' });
}

/** Copies a play as text, which can be pasted where a file can't be. */
export const copyPlay = ({ notices }: Editor, { title, bytes }: SharedPlay): Promise<void> =>
  copyText(notices, `${title} as text`, playToText(bytes));

/** Copies a link to this page with a play and its level. */
export async function copyPlayLink({ notices, terms }: Editor, { title, bytes, played }: SharedPlay): Promise<void> {
  if (played === null) {
    notices.show('warning', 'The level has changed since this play, so a link can’t include it. Save the play as a file.', {
      topic: 'clipboard',
    });
    return;
  }
  // runs would give the solution away, and the play does not need them
  const { runs: _, ...bare } = leavingFolder(played.file, played.rules);
  // the page of the link plays what the play was, whatever this one shows now
  const decoded = decodePlay(bytes);
  const { shown } = terms.getState();
  const under = decoded.ok ? termsAt(shown, decoded.play.accuracy) : shown;
  const linking = await linkTo(bare, under, `${location.origin}${location.pathname}`);
  const url = linking.ok ? `${linking.url}&play=${playToText(bytes)}` : '';
  if (!linking.ok || url.length > LONGEST_LINK) {
    notices.show('warning', 'The level is too large for a link. Save the play as a file, and send both files.', {
      topic: 'clipboard',
    });
    return;
  }
  await copyText(notices, `a link to ${title}`, url);
}
