import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../engine/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import { type EditedLevel, isSame } from '../document/index.ts';
import type { LiveProof } from './answer.ts';
import { AT_REST, WHILE_DRAGGED } from './patience.ts';
import { createProver } from './prover.ts';
import { type Reach, reachOf } from './reach.ts';

/** The proof of the open level, up to date after every change. */
export interface ProofStore {
  readonly store: StoreApi<LiveProof>;
  proof(): LiveProof;
  /** How far along time the shown run is to be shown. */
  readonly reach: StoreApi<Reach>;
  /** Which run is shown; the first one when it is null or there is none of that name. */
  showRun(name: string | null): void;
  setAccuracy(accuracy: AccuracyName): void;
  /** Rules that the folder sets from now on. */
  setFolderRules(rules: OwnRules): void;
  /** Stops following the level. */
  close(): void;
}

export interface ProofOptions {
  /** Name of the run that is shown at first. */
  readonly run?: string | null;
  /** Rules that the folder sets, which hold where the level has none of its own. */
  readonly rules?: OwnRules;
  /** Whether the level is played at all. */
  readonly checked?: boolean;
  /** Calls back once the page has rested for so many ms: then an answer may take longer. @returns takes it back */
  readonly afterRest?: (ms: number, call: () => void) => () => void;
}

/** ms without a change before what took too long is tried with more patience */
const REST = 120;

/** Follows a level: its proof is made anew within every change, so that one frame shows both. What would keep the page from its next frame is left out. */
export function createProofStore(
  level: EditedLevel,
  accuracy: AccuracyName,
  { run = null, rules = {}, checked = true, afterRest }: ProofOptions = {},
): ProofStore {
  const prover = createProver();
  let asked = { run, accuracy, rules };
  let forget = () => {};
  // who never asks again has to wait for all of it
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
    // first: whoever is told of the proof shows it that far
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
    // the hand has let go
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
    setAccuracy(name) {
      asked = { ...asked, accuracy: name };
      update();
    },
    setFolderRules(own) {
      asked = { ...asked, rules: own };
      update();
    },
    close() {
      for (const stop of stops) stop();
      forget();
    },
  };
}
