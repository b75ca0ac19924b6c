import type { CodeExplanation } from '../../schema/index.ts';

/** The names that the limits of a check have where problems are read. */
export interface Terms {
  /** The longest run that counts: `--max-time`. */
  readonly longestRun: string;
  /** The most work that a level may cost: `--max-work`. */
  readonly mostWork: string;
}

interface Meaning {
  readonly severity: CodeExplanation['severity'];
  readonly title: string;
  readonly why: (terms: Terms) => string;
}

/** The problems that only a check can find, in the order in which they are listed. */
const MEANINGS = {
  'run-does-not-complete': {
    severity: 'error',
    title: 'a scripted run does not end in the black hole',
    why: () =>
      'A run is the proof that a level can be completed. When none of them completes it the level is broken: nobody knows a way ' +
      'through. Beside a run that does complete it this is a warning: the failing one proves nothing.',
  },
  'no-run': {
    severity: 'error',
    title: 'the level has no run',
    why: () =>
      'Without a run that completes it nothing shows that a player can complete the level: it is unproven, and `gq check` is not green.',
  },
  'found-run': {
    severity: 'warning',
    title: 'the level is completable, but not by a run of its own',
    why: () =>
      '`gq check --solve` found a run where no scripted one completes the level. It was replayed from the start, so the level can be ' +
      'completed; but the next check has to search again, and a search with another seed or budget may not find it.',
  },
  'no-run-found': {
    severity: 'error',
    title: 'a search found neither a run nor a proof that there is none',
    why: () =>
      'Nothing is known: the level may be impossible, or very hard. The message says how much was tried and how near it came; that ' +
      'is no proof. A level that nobody can show to be completable should not be shipped.',
  },
  'proved-impossible': {
    severity: 'error',
    title: 'nobody can complete the level',
    why: ({ longestRun }) =>
      'It is proved that no way of pressing and releasing leads to the black hole: out of range of everything reachable, enclosed by ' +
      'what is deadly, bound to a line, and the like. The proof is rigorous for the game at this accuracy, rounding included, for ' +
      `runs as long as ${longestRun}, and a separate small checker has confirmed its certificate.`,
  },
  'mineral-never-collectable': {
    severity: 'warning',
    title: 'nobody can collect a mineral',
    why: () =>
      'It is proved, as for the black hole, that no run touches this mineral: "all minerals" can never be achieved in this level.',
  },
  'low-slack': {
    severity: 'warning',
    title: 'a run forgives nothing',
    why: () =>
      'Presses and releases that come one tick (1/60 s) too early or too late can make it fail: every combination was tried. People ' +
      'are off by 30 ms and more, so this run shows that the level can be completed, hardly that somebody will. It is looked for by ' +
      '`gq check --solve` and `--require-slack` alone, since it takes long.',
  },
  'slack-below-required': {
    severity: 'error',
    title: 'a run forgives less than --require-slack asks for',
    why: () =>
      '`gq check --require-slack K` asks that every run that completes a level still does when all its presses and releases are off by ' +
      'up to K ticks (1/60 s), in every combination. The message has a combination that fails. The verdict stays: the level is completable.',
  },
  'verdict-hangs-on-accuracy': {
    severity: 'warning',
    title: 'a run completes the level at some accuracies and not at others',
    why: () =>
      'She passes something deadly, a change of target or the edge of the range so closely that how exactly the motion is simulated ' +
      'decides how the run ends. A player, whose hand is less exact than any of these, would hardly succeed that way. Under `arcade`, ' +
      "the original's frames, runs differ most: what was found there often doesn't hold in continuous time, and the other way round. " +
      'A run that fails everywhere, in whatever ways, is not reported.',
  },
  'work-limit': {
    severity: 'error',
    title: 'the level costs more work than allowed',
    why: ({ mostWork }) =>
      'Levels may come from strangers, and a valid one can be made to take hours: thousands of aliens awake, orbits of a thousandth of a ' +
      'pixel, runs of a thousand presses. So work is counted, in pieces of motion and what takes as long as one, and memory of recordings ' +
      `in bytes; the count is the same on every machine. Past ${mostWork} a level whose runs were not played to the end is unproven. ` +
      'Where a run has completed it the verdict stays, and this is a warning of what was left out.',
  },
  'unreadable-file': {
    severity: 'error',
    title: 'a file or directory can not be read',
    why: () => 'A level that was not read was not checked. The check ends with exit code 2, so that nobody takes it for a pass.',
  },
  crashed: {
    severity: 'error',
    title: 'gq failed on this level',
    why: () => 'This is a bug in gq, not in the level: every input should end in a verdict.',
  },
} as const satisfies Record<string, Meaning>;

/** The code of a problem that only a check can find. */
export type CheckCode = keyof typeof MEANINGS;

/** What can be done about a problem where it is read. */
export interface Advice {
  readonly fix: string;
  /** An addition to the explanation, one sentence or more. */
  readonly also?: string;
  readonly example?: string;
}

/** Explains the codes for which there is advice. */
export function explainCodes(advice: Readonly<Partial<Record<CheckCode, Advice>>>, terms: Terms): CodeExplanation[] {
  return (Object.keys(MEANINGS) as CheckCode[]).flatMap((code) => {
    const known = advice[code];
    if (known === undefined) return [];
    const { severity, title, why } = MEANINGS[code];
    const { fix, also, example } = known;
    const whole = also === undefined ? why(terms) : `${why(terms)} ${also}`;
    return [{ code, severity, title, why: whole, fix, ...(example !== undefined && { example }) }];
  });
}
