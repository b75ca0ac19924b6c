import type { Editor, OpenLevel } from '../../context/index.ts';
import { folderRulesIn } from '../../files/index.ts';
import { keepAsRun, keepHolds, makeProof } from '../../play/index.ts';
import { copyPlay, copyPlayLink, type SharedPlay, savePlay } from '../../plays/index.ts';
import { hashNow, type OpenedPlay, shelfOf } from '../../shelf/index.ts';
import type { MenuEntry } from '../tree/index.ts';
import type { AttemptRow } from './attempt-rows.ts';

/** Shows a replay of a row over the canvas. */
export function replayRow({ session }: Editor, level: OpenLevel, row: AttemptRow): void {
  const { title, holds, tick, outcome, attempt, play } = row;
  const accuracy = attempt?.accuracy ?? play?.play.accuracy ?? session.getState().accuracy;
  if (tick === 0) return;
  const isSame =
    attempt === null || attempt.played === undefined ? hasLevelOf(level, play) : attempt.played.file === level.document.file();
  const end = isSame ? row.end : 'The level has changed since: this is what the same holds do now.';
  shelfOf(level).show({ title, holds, accuracy, tick, end, look: outcome === 'completed' ? 'won' : 'lost' });
  session.setState({ mode: 'play', playFrom: 'replay', isPlayingBack: false });
}

const hasLevelOf = (level: OpenLevel, play: OpenedPlay | null): boolean => play === null || play.play.level === hashNow(level);

/** Adds the holds of a row to the level. */
export function keepRow(editor: Editor, level: OpenLevel, { attempt, title, holds, outcome }: AttemptRow): void {
  const parts = { editor, level };
  if (attempt === null) keepHolds(parts, title, holds);
  else if (outcome === 'completed') makeProof(parts, attempt);
  else keepAsRun(parts, attempt);
}

/** A row to be sent; null if it can't be. */
export function sharedRow(editor: Editor, level: OpenLevel, { title, attempt, play }: AttemptRow): SharedPlay | null {
  if (attempt !== null)
    return attempt.played === undefined ? null : { title, bytes: attempt.played.bytes, played: attempt.played };
  if (play === null) return null;
  const isSame = play.play.level === hashNow(level);
  const { own: rules } = folderRulesIn(editor.workspace.store.getState());
  return { title, bytes: play.bytes, played: isSame ? { file: level.document.file(), rules } : null };
}

/** The entries of a row's menu. */
export function rowMenu(editor: Editor, level: OpenLevel, row: AttemptRow): readonly MenuEntry[] {
  const { attempt, tick } = row;
  const shared = sharedRow(editor, level, row);
  const name = level.document.file().name;
  return [
    { title: 'Replay', keys: 'Enter', disabled: tick === 0, run: () => replayRow(editor, level, row) },
    { title: 'Keep as a run', run: () => keepRow(editor, level, row) },
    null,
    {
      title: 'Save as a .gqr file',
      disabled: shared === null,
      run: () => shared !== null && void savePlay(editor, name, shared),
    },
    { title: 'Copy as text', disabled: shared === null, run: () => shared !== null && void copyPlay(editor, shared) },
    { title: 'Copy a link', disabled: shared === null, run: () => shared !== null && void copyPlayLink(editor, shared) },
    ...(attempt === null
      ? []
      : [null, { title: 'Discard', keys: 'Del', run: () => level.attempts.remove(attempt.number) } satisfies MenuEntry]),
  ];
}
