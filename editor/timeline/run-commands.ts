import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { addHold, addRun, deleteHolds, freeRunName, splitHold } from '../core/document/index.ts';
import type { SessionStore } from '../core/session/index.ts';

/** length of a new hold, in ticks */
const NEW_HOLD = 30;

interface RunCommandParts {
  /** The last tick of the shown run. */
  readonly end: () => number;
  /** The last tick of all shown and compared runs. */
  readonly last: () => number;
  /** Opens the field for a new note of the shown run. */
  readonly writeNote: (tick: number) => void;
}

/** Commands for editing a run without the pointer. */
export function runCommands(
  { session }: Editor,
  { document, proof, selection }: OpenLevel,
  { end, last, writeNote }: RunCommandParts,
): readonly Command[] {
  const shown = () => proof.proof().run.name;
  const goTo = (tick: number) =>
    session.setState({ tick: Math.min(last(), Math.max(0, Math.round(tick))), isPlayingBack: false });
  const step = (by: number) => goTo(session.getState().tick + by);
  const newRun = () => {
    const name = freeRunName(document.file(), 'solution');
    document.change('New run', addRun(name, []));
    session.setState({ run: name });
    return name;
  };
  const remove = (ripple: boolean) => {
    const { run, holds } = selection.store.getState();
    if (run !== null) document.change('Delete holds', deleteHolds(run, holds, { ripple }));
  };
  const needsHolds = () => (selection.store.getState().holds.length > 0 ? null : 'select a hold in the gun lane first');
  return [
    {
      id: 'run.playback',
      title: 'Play back the run',
      group: 'Run',
      keys: ['k'],
      run: () => {
        const { isPlayingBack, tick } = session.getState();
        session.setState({ isPlayingBack: !isPlayingBack, tick: !isPlayingBack && tick >= last() ? 0 : tick, hoverTick: null });
      },
    },
    { id: 'run.back', title: 'Previous tick', group: 'Run', keys: ['Comma'], run: () => step(-1) },
    { id: 'run.on', title: 'Next tick', group: 'Run', keys: ['Period'], run: () => step(1) },
    { id: 'run.back-far', title: 'Back one second', group: 'Run', keys: ['Shift+Comma'], run: () => step(-60) },
    { id: 'run.on-far', title: 'Forward one second', group: 'Run', keys: ['Shift+Period'], run: () => step(60) },
    { id: 'run.first', title: 'Go to the start of the run', group: 'Run', keys: ['Home'], run: () => goTo(0) },
    { id: 'run.last', title: 'Go to the end of the run', group: 'Run', keys: ['End'], run: () => goTo(end()) },
    { id: 'run.new', title: 'New run', group: 'Run', run: newRun },
    {
      id: 'run.add-hold',
      title: 'Add a hold at the current tick',
      group: 'Run',
      keys: ['i'],
      run: () => {
        const tick = Math.round(session.getState().tick);
        const name = shown() ?? newRun();
        document.change('Add hold', addHold(name, tick, tick + NEW_HOLD));
      },
    },
    {
      id: 'run.split-hold',
      title: 'Split the hold at the current tick',
      group: 'Run',
      keys: ['s'],
      needs: () => (shown() === null ? 'show a run first' : null),
      run: () => {
        const { name, holds } = proof.proof().run;
        const tick = Math.round(session.getState().tick);
        const index = holds.findIndex(([press, release]) => press < tick && tick < release);
        if (name !== null && index >= 0) document.change('Split hold', splitHold(name, index, tick));
      },
    },
    {
      id: 'run.add-note',
      title: 'Add a note at the current tick',
      group: 'Run',
      keys: ['Shift+n'],
      needs: () => (shown() === null ? 'show a run first' : null),
      run: () => writeNote(Math.round(session.getState().tick)),
    },
    {
      id: 'run.delete-holds',
      title: 'Delete the selected holds',
      group: 'Run',
      keys: ['Delete', 'Backspace'],
      needs: needsHolds,
      run: () => remove(false),
    },
    {
      id: 'run.delete-holds-ripple',
      title: 'Delete the selected holds and close the gap',
      group: 'Run',
      keys: ['Shift+Delete', 'Alt+Delete'],
      needs: needsHolds,
      run: () => remove(true),
    },
  ];
}

/**
 * Plays the run in the timeline while `isPlayingBack` is set; stops at its end.
 * @param end the last tick of the shown run
 * @returns stops it
 */
export function followPlayback(session: SessionStore, end: () => number): () => void {
  let frame = 0;
  let last = 0;
  const onFrame = (now: number) => {
    const { isPlayingBack, tick, rate } = session.getState();
    // Requested before the session changes: the subscriber must see that a frame is pending.
    frame = isPlayingBack ? requestAnimationFrame(onFrame) : 0;
    if (!isPlayingBack) return;
    const next = tick + ((now - last) / 1000) * 60 * rate;
    last = now;
    if (next >= end()) session.setState({ tick: end(), isPlayingBack: false });
    else session.setState({ tick: next });
  };
  const stop = session.subscribe(({ isPlayingBack }) => {
    if (!isPlayingBack || frame !== 0) return;
    last = performance.now();
    frame = requestAnimationFrame(onFrame);
  });
  return () => {
    stop();
    cancelAnimationFrame(frame);
  };
}
