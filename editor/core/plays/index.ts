import type { Editor } from '../context/index.ts';
import { fetched } from '../panel/index.ts';
import type { GivenPlay } from '../shelf/index.ts';
import type { OpenOptions } from './open-plays.ts';

export { choosePlayFolder, choosePlays, droppedFiles, type Reading, readingOf } from './play-files.ts';
export { copyPlay, copyPlayLink, type SharedPlay, savePlay } from './share-plays.ts';

// what reads and verifies plays comes when somebody opens some

const openPlaysOf = (editor: Editor) => fetched(editor, () => import('./open-plays.ts'));

/** Reads files of plays and opens them. */
export async function openPlayFiles(editor: Editor, files: readonly File[]): Promise<void> {
  await (await openPlaysOf(editor))?.openPlayFiles(editor, files);
}

/**
 * Opens plays: those of the open level become attempts of it. For those of other levels of the folder, their level is offered
 * by name; others are refused.
 */
export async function openPlays(editor: Editor, given: readonly GivenPlay[], options: OpenOptions = {}): Promise<void> {
  await (await openPlaysOf(editor))?.openPlays(editor, given, options);
}

/**
 * Opens plays of a link with their level.
 * @param answered resolves once the user has answered about the level of the link; null: it has none
 */
export async function openLinkedPlays(
  editor: Editor,
  given: readonly GivenPlay[],
  { answered, ...options }: OpenOptions & { readonly answered: (() => Promise<void>) | null },
): Promise<void> {
  const there = await openPlaysOf(editor);
  if (there === null) return;
  if (answered !== null) {
    const { byLevel } = there.groupPlays(given);
    const found = await there.levelsByHash(editor, new Set(byLevel.keys()));
    // the folder has the level already, so that nothing needs to be added
    if (found.size > 0) editor.incoming.setState(null, true);
    else await answered();
  }
  await there.openPlays(editor, given, { ...options, withLevel: true });
}
