import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { isSame } from '../../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import type { LiveProof } from './answer.ts';
import { AT_REST, WHILE_DRAGGED } from './patience.ts';
import { createProver } from './prover.ts';
import { type Reach, reachOf } from './reach.ts';

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

export interface ProofOptions {
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
  const isInHand = () => !isSame(level.settledFile(), level.file());
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
