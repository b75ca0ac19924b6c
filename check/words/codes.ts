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
    title: 'a run does not complete the level',
    why: () =>
      'A run shows that a level can be completed. When a level has runs and none of them completes it, the level is broken. If another ' +
      'run completes the level, this is only a warning: the level can be completed, and the failing run shows nothing.',
  },
  'no-run': {
    severity: 'error',
    title: 'the level has no run',
    why: () =>
      'Without a run that completes it, nothing shows that a player can complete the level. The level is unproven, and `gq check` fails.',
  },
  'found-run': {
    severity: 'warning',
    title: 'a search completed the level, but none of its own runs does',
    why: () =>
      'None of the runs in the file completes the level, but `gq check --solve` found one that does. That run was replayed from the ' +
      'start, so the level can be completed. The next check has to search again, and with another seed or budget it may find nothing.',
  },
  'no-run-found': {
    severity: 'error',
    title: 'a search found neither a run nor a proof that there is none',
    why: () =>
      'The level may be impossible, or only very hard. The message says how much was tried and gives the closest approach to the black ' +
      'hole; neither proves anything. Do not ship a level that nobody can show to be completable.',
  },
  'proved-impossible': {
    severity: 'error',
    title: 'nobody can complete the level',
    why: ({ longestRun }) =>
      'It is proved that no sequence of presses and releases leads to the black hole: because it is out of range of every asteroid that ' +
      'she can reach, for example, or closed off by hazards, or beside a line that she cannot leave. The proof is rigorous for the game ' +
      `at this accuracy, rounding included, for runs of up to ${longestRun}. A separate small checker has confirmed its certificate.`,
  },
  'mineral-never-collectable': {
    severity: 'warning',
    title: 'nobody can collect a mineral',
    why: () => 'It is proved that no run touches this mineral, so nobody can complete this level with all minerals.',
  },
  softlock: {
    severity: 'warning',
    title: 'she can live on for long after all is lost',
    why: () =>
      'It is proved that the black hole cannot be reached any more from some place on, whatever the player does. But nothing ends the run ' +
      'there: she was seen alive for five seconds and more after it. A player does not know, and tries on in vain. Only ' +
      '`gq check --softlocks` looks for this, because it takes long. States from which a search merely found no run are listed by ' +
      '`--format json`, and are no problem: that proves nothing.',
  },
  'low-slack': {
    severity: 'warning',
    title: 'a run forgives no error in its timing',
    why: () =>
      'The run can fail when its presses and releases come one tick (1/60 s) too early or too late; every combination was tried. People ' +
      'are off by 30 ms and more. So the run shows that the level can be completed, but a player will hardly manage to play it. Only ' +
      '`gq check --solve` and `--require-slack` look for this, because it takes long.',
  },
  'slack-below-required': {
    severity: 'error',
    title: 'a run forgives less than --require-slack requires',
    why: () =>
      '`gq check --require-slack K` requires every run that completes a level to complete it even when all its presses and releases are ' +
      'off by up to K ticks (1/60 s), in every combination. The message names a combination that fails. The verdict is still completable.',
  },
  'verdict-hangs-on-accuracy': {
    severity: 'warning',
    title: 'a run completes the level at some accuracies and not at others',
    why: () =>
      'She passes so close to a hazard, a change of target or the edge of the range that the outcome depends on how exactly the motion ' +
      'is simulated. A player cannot time a press that exactly, and would hardly succeed this way. Runs differ most under `arcade`, ' +
      "the original's frames: a run found there often fails in continuous time, and the other way round. " +
      'A run that fails at every accuracy is not reported, even if it fails in different ways.',
  },
  'work-limit': {
    severity: 'error',
    title: 'the level costs more work than allowed',
    why: ({ mostWork }) =>
      'Levels may come from strangers, and a valid level can be made to take hours: thousands of aliens awake, orbits of a thousandth of ' +
      'a pixel, runs of a thousand presses. So a check counts its work in pieces of motion, or what takes as long as one, and the memory ' +
      `of recordings in bytes. The counts are the same on every machine. When they reach ${mostWork}, the check stops, and a level whose ` +
      'runs were not played to the end is unproven. If a run has completed the level, the verdict stays, and this is only a warning that ' +
      'says what was left out.',
  },
  'result-changed': {
    severity: 'error',
    title: 'the result of a level is not the one that was agreed on',
    why: () =>
      'A lock file records what was agreed on for each level: verdict, end of the run, minerals, certified ticks and the hash of the ' +
      'motion. A difference means that the level, the rules or the toolkit has changed since, and that the level plays differently now. ' +
      'The message says what it is now and what it was before. Where rules differ, it names them: then the level may be untouched.',
  },
  'not-in-lock': {
    severity: 'error',
    title: 'nothing was agreed on for a level',
    why: () =>
      'The check compares levels with a lock file, and the lock has no entry for this level. A later change of its result would not be ' +
      'noticed. The level is new or has another name, or the lock was not updated with it.',
  },
  'unused-allow': {
    severity: 'warning',
    title: 'a level allows a problem that it does not have',
    why: () =>
      'The problem was fixed, or its code is not the one that was meant. If it stays, it hides the next problem of this kind, which ' +
      'nobody has looked at.',
  },
  'pack-missing-level': {
    severity: 'error',
    title: 'pack.json lists a level that is not there',
    why: () =>
      'A pack is played in the order of its list. A level that was renamed or deleted without the list leaves a hole in the game, and ' +
      '`gq build` refuses to make a page with one.',
  },
  'pack-repeated-level': {
    severity: 'error',
    title: 'pack.json lists a level twice',
    why: () => 'A game keeps the progress of a level under its id, and cannot tell two places of the same level apart.',
  },
  'pack-unlisted-level': {
    severity: 'warning',
    title: 'pack.json does not list a level of its folder',
    why: () =>
      'Reports show it after the listed ones, and `gq build` leaves it out. It may be a draft, or one that somebody forgot to list.',
  },
  'pack-introduction': {
    severity: 'warning',
    title: 'a level introduces several things at once, or not what it is meant to',
    why: () =>
      'Players learn an effect best in a level where it is the only new thing: when they fail, they know why. The level introduces an ' +
      'effect if no level before it in pack.json calls for it. Effects that every level has, such as the gun, do not count. Where two ' +
      'belong together, "introduces" says so; if it names something that the level does not introduce, that is reported as well. ' +
      'Nothing is said of what follows a level that is not valid.',
  },
  'pack-empty-chapter': {
    severity: 'warning',
    title: 'a chapter of pack.json has no level',
    why: () => 'The heading stands above nothing: its levels were moved or removed, and it was left behind.',
  },
  'unreadable-file': {
    severity: 'error',
    title: 'a file or directory cannot be read',
    why: () =>
      'A level that cannot be read is not checked. The check ends with exit code 2, so that nobody mistakes it for a pass.',
  },
  crashed: {
    severity: 'error',
    title: 'gq failed on this level',
    why: () => 'This is a bug in gq, not in the level: every file should get a verdict.',
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
