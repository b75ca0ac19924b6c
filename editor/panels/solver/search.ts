import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type Candidate, type Goal, mineralsNeeded, type Proof, proofPicture, verifyRun } from '../../../solver/index.ts';
import type { Ghost } from '../../canvas/layers/way-layer.ts';
import { addRun, type EditedLevel, freeRunName, replaceHolds } from '../../document/index.ts';
import type { ProofStore } from '../../proof/index.ts';
import type { SessionStore } from '../../session/index.ts';
import type { Job, Results, Solving, Workers } from '../../workers/index.ts';
import { type GhostShelf, putGhosts } from './ghost-shelf.ts';
import type { OverlayStore } from './overlay.ts';
import { wayOf } from './ways.ts';
import { aimOf, goalOf, type Wish, type WishStore } from './wish.ts';

/** A run that was found, and whether it still does what it was found for. */
export interface Found {
  /** The same for the same holds. */
  readonly id: string;
  readonly candidate: Candidate;
  /** Chance of success with timing noise of 40 ms, 0 to 1; null where it was not measured. */
  readonly p40: number | null;
  readonly certified: boolean;
  /** False: the level has changed since, and in this one the run fails. */
  readonly works: boolean;
}

export interface SearchState {
  /** `stale`: it was stopped since the level changed. */
  readonly phase: 'idle' | 'running' | 'done' | 'cancelled' | 'stale' | 'failed';
  /** Of a failure. */
  readonly message: string | null;
  /** ms spent */
  readonly ms: number;
  /** What it was asked for; null before the first search. */
  readonly wish: Wish | null;
  readonly solving: Solving | null;
  /** Best first. */
  readonly found: readonly Found[];
  readonly impossible: Proof | null;
  readonly mineralProofs: Results['proofs']['minerals'];
  /** It is proved that the minerals asked for can't all be had. */
  readonly isHopeless: boolean;
  /** The level has changed since it was searched. */
  readonly isOld: boolean;
  /** Id of the one that is pointed at. */
  readonly hovered: string | null;
}

const IDLE: SearchState = {
  phase: 'idle',
  message: null,
  ms: 0,
  wish: null,
  solving: null,
  found: [],
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: false,
  hovered: null,
};

/** What the run is called that shows first that a level can be completed. */
const SOLUTION = 'solution';

/** Different runs that are kept and shown. */
export const COUNT = 5;
/** ms after a change of the level before found runs are tried in it */
const SETTLE = 200;

/** The search for runs of one level. */
export interface SearchDesk {
  readonly store: StoreApi<SearchState>;
  /** Looks for runs, from the start. */
  start(): void;
  /** Stops; what was found stays. */
  cancel(): void;
  /** Puts away what was found. */
  clear(): void;
  /** Shows this one alone on the canvas; null: all of them. */
  hover(id: string | null): void;
  /**
   * Puts a run into the level and shows it. Where no run completes the level and this one does, it comes first: it is the proof.
   * @param into name of the run whose place it takes; a new one when left out
   * @param as what a new run is called; by what it was looked for when left out
   */
  use(holds: readonly Hold[], into?: string, as?: string): void;
  close(): void;
}

export interface SearchParts {
  readonly level: GhostShelf & { readonly document: EditedLevel; readonly proof: ProofStore };
  readonly session: SessionStore;
  readonly workers: Pick<Workers, 'start'>;
  readonly wish: WishStore;
  readonly overlay: OverlayStore;
  /** A clock, ms. */
  readonly now: () => number;
}

/** The level without its runs: what a worker needs. */
export const withoutRuns = (level: Level): Level => ({ ...level, runs: [] });

/** The search of a level: its jobs, what it has found, its ghosts and what it draws. */
export function createSearchDesk({ level, session, workers, wish, overlay, now }: SearchParts): SearchDesk {
  const { document, proof } = level;
  const store = createStore<SearchState>(() => IDLE);
  let jobs: readonly Job<'solve' | 'proofs'>[] = [];
  let began = 0;
  // what was searched: another scene is another level
  let scene: Scene | null = null;
  let goal: Goal = { minerals: 'any' };
  let timer: ReturnType<typeof setTimeout> | null = null;
  const ways = new Map<string, Float32Array>();
  // what was found while one was pointed at: the list stands still under the pointer
  let unseen: readonly Found[] | null = null;

  const stopJobs = () => {
    for (const job of jobs) job.cancel();
    jobs = [];
  };

  const wayFor = (on: Scene, holds: readonly Hold[], until?: number): Float32Array => {
    const key = `${holds.join()} ${until}`;
    const known = ways.get(key) ?? wayOf(on, holds, until);
    ways.set(key, known);
    return known;
  };
  const drawGhosts = () => {
    const { found, hovered, solving, impossible } = store.getState();
    if (scene === null) return;
    const on = scene;
    const ghosts = found
      .filter(({ id }) => hovered === null || hovered === id)
      .map(
        ({ id, candidate }, i): Ghost => ({
          id: `found-${id}`,
          label: `found ${i + 1}`,
          points: wayFor(on, candidate.holds),
          look: 'candidate',
        }),
      );
    const { closest } = solving ?? { closest: null };
    if (found.length === 0 && closest !== null && impossible === null) {
      const points = wayFor(on, closest.holds, closest.tick + 1);
      ghosts.push({ id: 'closest', label: 'closest approach', points, look: 'candidate' });
    }
    putGhosts(level, 'candidate', ghosts);
  };

  const tell = (solving: Solving) => {
    const found = solving.solutions.map(
      (solution): Found => ({
        id: solution.holds.join(),
        candidate: solution,
        p40: solution.p40?.p ?? null,
        certified: solution.certified,
        works: true,
      }),
    );
    const { hovered, found: listed } = store.getState();
    unseen = hovered === null ? null : found;
    store.setState({ solving, found: hovered === null ? found : listed, ms: now() - began });
    overlay.setState({ heat: solving.explored });
    drawGhosts();
  };

  /** The level has changed: the search is about another one, and what it found is tried in this one. */
  const recheck = () => {
    timer = null;
    const current = proof.proof();
    if (scene === null || current.scene === scene) return;
    const wasRunning = store.getState().phase === 'running';
    stopJobs();
    scene = current.scene;
    unseen = null;
    const changed = current.scene;
    ways.clear();
    const found = store.getState().found.map((one): Found => {
      const verified = verifyRun(changed, one.candidate.holds, goal);
      // chances were those in the level as it was
      return { ...one, candidate: verified ?? one.candidate, works: verified !== null, p40: null, certified: false };
    });
    const { phase } = store.getState();
    store.setState({
      found,
      impossible: null,
      mineralProofs: [],
      isHopeless: false,
      isOld: true,
      solving: null,
      phase: wasRunning ? 'stale' : phase,
    });
    overlay.setState({ heat: null, proof: null });
    drawGhosts();
  };
  const stopFollowing = proof.store.subscribe(({ scene: current }) => {
    if (scene === null || current === scene) return;
    if (timer !== null) clearTimeout(timer);
    timer = setTimeout(recheck, SETTLE);
  });

  const desk: SearchDesk = {
    store,
    start() {
      stopJobs();
      ways.clear();
      unseen = null;
      began = now();
      const { level: asked, accuracy, scene: current } = proof.proof();
      const wished = wish.getState();
      scene = current;
      goal = goalOf(wished, asked.minerals.length);
      store.setState({ ...IDLE, phase: 'running', wish: wished });
      overlay.setState({ heat: null, proof: null });
      putGhosts(level, 'candidate', []);
      const learn = ({ impossible, minerals }: Results['proofs']) => {
        store.setState({ impossible, mineralProofs: minerals });
        const shown = impossible ?? minerals[0]?.proof ?? null;
        overlay.setState({ proof: shown === null ? null : proofPicture(asked, shown) });
        // more minerals are asked for than can be had
        const isHopeless = mineralsNeeded(goal, asked.minerals.length) > asked.minerals.length - minerals.length;
        store.setState({ isHopeless });
        if ((impossible === null && !isHopeless) || store.getState().phase !== 'running') return;
        // nothing is left to look for
        jobs[0]?.cancel();
        store.setState({ phase: 'done', ms: now() - began });
        drawGhosts();
      };
      const played = { level: withoutRuns(asked), accuracy };
      const { objective, seed, budget } = wished;
      // who asks for any run wants another one
      const known = objective === 'first' ? [] : asked.runs.map(({ holds }) => holds);
      const solve = workers.start(
        'solve',
        { ...played, goal, objective, count: COUNT, known, seed, lane: 0, budget: 1000 * budget },
        (so) => {
          if (jobs.includes(solve)) tell(so);
        },
      );
      const prove = workers.start('proofs', { ...played, collected: [] }, (so) => {
        if (jobs.includes(prove)) learn(so);
      });
      jobs = [solve, prove];
      void solve.end.then((end) => {
        if (!jobs.includes(solve)) return;
        if (end.kind === 'done') tell(end.result);
        if (end.kind === 'failed' || end.kind === 'gaveUp') store.setState({ phase: 'failed', message: end.message });
        else if (store.getState().phase === 'running') store.setState({ phase: end.kind, ms: now() - began });
      });
      void prove.end.then((end) => {
        if (jobs.includes(prove) && end.kind === 'done') learn(end.result);
      });
    },
    cancel() {
      if (store.getState().phase !== 'running') return;
      stopJobs();
      store.setState({ phase: 'cancelled', ms: now() - began });
    },
    clear() {
      stopJobs();
      scene = null;
      unseen = null;
      store.setState(IDLE);
      overlay.setState({ heat: null, proof: null });
      putGhosts(level, 'candidate', []);
    },
    hover(id) {
      if (store.getState().hovered === id) return;
      const { found } = store.getState();
      store.setState({ hovered: id, found: id === null ? (unseen ?? found) : found });
      if (id === null) unseen = null;
      drawGhosts();
    },
    use(holds, into, as) {
      const file = document.file();
      if (into !== undefined) {
        document.change(`Replace run ${into}`, replaceHolds(into, holds));
        session.setState({ run: into });
        return;
      }
      const { provenBy, scene: current } = proof.proof();
      // the first run is the one that is shown, but what fails in the level as it is now proves nothing
      const proves = provenBy === null && verifyRun(current, holds) !== null;
      const place = proves ? 'first' : 'last';
      const hasSolution = file.runs?.some(({ name }) => name === SOLUTION) === true;
      const aim = () => {
        const { wish: wished, found } = store.getState();
        const rank = found.findIndex(({ id }) => id === holds.join());
        return wished === null || rank < 0 ? SOLUTION : aimOf(wished, rank + 1);
      };
      const name = freeRunName(file, proves && !hasSolution ? SOLUTION : (as ?? aim()));
      if (document.change(`Add run ${name}`, addRun(name, holds, place)).ok) session.setState({ run: name });
    },
    close() {
      stopFollowing();
      if (timer !== null) clearTimeout(timer);
      stopJobs();
    },
  };
  return desk;
}
