import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { isSame } from '../../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { AT_REST, type LiveProof, WHILE_DRAGGED } from './answer.ts';
import { createProver } from './prover.ts';

/** The live simulation and verdict of the open level, updated with every change. */
export interface ProofStore {
  readonly store: StoreApi<LiveProof>;
  proof(): LiveProof;
  /** How far along time the shown run should be displayed. */
  readonly reach: StoreApi<Reach>;
  /** Selects the shown run; the first one if the name is null or unknown. */
  showRun(name: string | null): void;
  /** Sets the terms under which the level is shown. */
  setTerms(terms: Terms): void;
  /** Stops following the level. */
  close(): void;
}

interface ProofOptions {
  /** The run shown at first. */
  readonly run?: string | null;
  /** Whether the level is simulated at all. */
  readonly checked?: boolean;
  /** Calls back once the page has been at rest for `ms`: then an answer may take longer. @returns cancels it */
  readonly afterRest?: (ms: number, call: () => void) => () => void;
}

/** ms without a change before an incomplete answer is tried with more patience */
const REST = 120;

/**
 * Follows a level and computes its proof again within every change, so that one frame shows both. What would delay the next
 * frame is left out.
 */
export function createProofStore(
  level: EditedLevel,
  terms: Terms,
  { run = null, checked = true, afterRest }: ProofOptions = {},
): ProofStore {
  const prover = createProver();
  let asked = { run, terms };
  let forget = () => {};
  // without a second try, everything is computed at once
  const most = (patience: number) => (afterRest === undefined ? Number.POSITIVE_INFINITY : patience);
  const prove = (patience: number) => prover.prove({ file: level.file(), ...asked, patience: checked ? most(patience) : 0 });
  const store = createStore<LiveProof>(() => prove(WHILE_DRAGGED));
  const isInHand = () => !isSame(level.committedFile(), level.file());
  const reach = createStore<Reach>(() => reachOf(store.getState(), null, isInHand));
  const stretch = (proof: LiveProof) => {
    const before = reach.getState();
    const now = reachOf(proof, before, isInHand);
    if (now.ticks !== before.ticks || now.formerEnd !== before.formerEnd || now.run !== before.run) reach.setState(now, true);
  };
  const show = (proof: LiveProof) => {
    // first, as subscribers of the proof use the new reach
    stretch(proof);
    store.setState(proof, true);
  };
  const rest = () => {
    forget();
    const { limit } = store.getState();
    if (afterRest === undefined || (limit !== 'run' && limit !== 'others')) return;
    forget = afterRest(REST, () => show(prove(AT_REST)));
  };
  const update = () => {
    show(prove(WHILE_DRAGGED));
    rest();
  };
  rest();
  const stops = [
    level.subscribe(update),
    // the gesture has ended
    level.onStep(() => stretch(store.getState())),
  ];
  return {
    store,
    proof: () => store.getState(),
    reach,
    showRun(name) {
      asked = { ...asked, run: name };
      update();
    },
    setTerms(now) {
      asked = { ...asked, terms: now };
      update();
    },
    close() {
      for (const stop of stops) stop();
      forget();
    },
  };
}

/** How far along time a run is displayed. */
export interface Reach {
  /** The run that it belongs to. */
  readonly run: string | null;
  /** The longest run time since the run was shown or last completed the level, ticks. */
  readonly formerEnd: number;
  /** The displayed ticks: up to the end, the former end and the last hold. */
  readonly ticks: number;
}

/**
 * How far a run should be displayed. If it fails early, what came after stays visible, so that it can be fixed.
 * @param isInHand whether a gesture is in progress: the display must not shrink during one
 */
function reachOf({ run, limit }: Pick<LiveProof, 'run' | 'limit'>, before: Reach | null, isInHand: () => boolean): Reach {
  const end = Math.max(1, run.way.count - 1);
  const known = before !== null && before.run === run.name ? before : null;
  const completes = limit !== 'run' && run.outcome === 'completed';
  // A last hold until she is through may have any release tick: it must not squeeze the run into a corner.
  const seenUntil = (press: number, release: number) => (completes && press < end ? Math.min(release, 2 * end) : release);
  const lastHold = run.holds.reduce((last, [press, release]) => Math.max(last, seenUntil(press, release)), 0);
  const upTo = (formerEnd: number): Reach => ({ run: run.name, formerEnd, ticks: Math.max(end, formerEnd, lastHold) });
  if (known === null) return upTo(end);
  // a run without an end has none to remember
  const longest = run.outcome === 'timeout' ? known.formerEnd : Math.max(known.formerEnd, end);
  const now = upTo(completes ? end : longest);
  if (now.ticks >= known.ticks && now.formerEnd >= known.formerEnd) return now;
  return isInHand() ? { ...now, formerEnd: longest, ticks: Math.max(known.ticks, now.ticks) } : now;
}
