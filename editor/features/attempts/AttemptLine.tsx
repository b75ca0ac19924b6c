import { DoorOpen, FileQuestionMark } from 'lucide-react';
import { TICK } from '../../../engine/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { folderTermsIn } from '../../core/files/index.ts';
import { keepAsRun, keepHolds, makeProof } from '../../core/levels/index.ts';
import { OutcomeSign } from '../../core/panel/index.ts';
import { copyPlay, copyPlayLink, type SharedPlay, savePlay } from '../../core/plays/index.ts';
import { hashNow } from '../../core/shelf/index.ts';
import { type MenuEntry, MoreButton } from '../../core/tree/index.ts';
import type { Loss } from '../../workers/index.ts';
import { lostFromInWords, sinceInWords } from '../lost/index.ts';
import { type AttemptRow, replayOf } from './attempt-rows.ts';

function Sign({ outcome }: Pick<AttemptRow, 'outcome'>) {
  if (outcome !== null && outcome !== 'left') return <OutcomeSign outcome={outcome} />;
  const Icon = outcome === null ? FileQuestionMark : DoorOpen;
  return (
    <span className={outcome === null ? 'runs__sign runs__sign--warn' : 'runs__sign'}>
      <Icon size={15} aria-hidden />
    </span>
  );
}

interface AttemptLineProps {
  readonly row: AttemptRow;
  /** Of the level. */
  readonly minerals: number;
  /** Since when it was lost; null: not known, or not lost. */
  readonly loss: Loss | null;
}

/** An attempt or a play in the list. */
export function AttemptLine({ row, minerals: all, loss }: AttemptLineProps) {
  const { title, end, tick, minerals, verdict, outcome } = row;
  return (
    <span className="attempt-line" title={loss === null ? `${title}: ${end}` : `${title}: ${end} It is ${sinceInWords(loss)}.`}>
      <Sign outcome={outcome} />
      <span className="runs__text">
        <span className="runs__line">
          <span className="runs__name">{title}</span>
          <span className="runs__time numbers">
            {all > 0 && minerals !== null && `◆ ${minerals}/${all} · `}
            {(tick * TICK).toFixed(2)} s
          </span>
        </span>
        <span className="runs__facts numbers">
          {verdict !== null && verdict !== 'ok' && <b className="attempt-line__verdict">{verdict} </b>}
          {end}
        </span>
        {loss !== null && <span className="runs__facts attempt-line__since numbers">{lostFromInWords(loss)}</span>}
      </span>
      <MoreButton />
    </span>
  );
}

/** Shows a replay of a row over the canvas. */
export function replayRow({ session }: Editor, level: OpenLevel, row: AttemptRow): void {
  if (row.tick === 0) return;
  session.setState({ mode: 'play', playFrom: replayOf(row, hashNow(level)), isPlayingBack: false });
}

/** Adds the holds of a row to the level. */
function keepRow(editor: Editor, level: OpenLevel, { attempt, title, holds, outcome }: AttemptRow): void {
  const parts = { editor, level };
  if (attempt === null) keepHolds(parts, title, holds);
  else if (outcome === 'completed') makeProof(parts, attempt);
  else keepAsRun(parts, attempt);
}

/** A row to be sent. */
function sharedRow({ workspace }: Editor, level: OpenLevel, row: AttemptRow): SharedPlay {
  const { title, bytes, attempt, playedOn } = row;
  const { rules } = folderTermsIn(workspace.store.getState());
  const now = playedOn === hashNow(level) ? { file: level.document.file(), rules } : null;
  return { title, bytes, played: attempt?.played ?? now };
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
    { title: 'Save as a .gqr file', run: () => void savePlay(editor, name, shared) },
    { title: 'Copy as text', run: () => void copyPlay(editor, shared) },
    { title: 'Copy a link', run: () => void copyPlayLink(editor, shared) },
    ...(attempt === null
      ? []
      : [null, { title: 'Discard', keys: 'Del', run: () => level.attempts.remove(attempt.number) } satisfies MenuEntry]),
  ];
}
