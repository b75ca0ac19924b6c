import type { AllowableCode } from '../../schema/index.ts';
import { completesItself, type Findings, verdictOfFindings } from '../findings.ts';
import type { CheckProblem } from './problem.ts';

/** What depends on a run that completes the level. Without one, nothing is known of it. */
const ABOUT_COMPLETING_RUNS: ReadonlySet<string> = new Set([
  'unused-asteroid',
  'low-slack',
  'slack-below-required',
  'verdict-hangs-on-accuracy',
] satisfies AllowableCode[]);

/** Whether the check would have found a problem of this code. */
function isSought(code: string, findings: Findings): boolean {
  const { cuts, sought } = findings;
  if (ABOUT_COMPLETING_RUNS.has(code) && verdictOfFindings(findings) !== 'completable') return false;
  switch (code) {
    case 'low-slack':
      return sought.slack === 'low';
    case 'slack-below-required':
      return sought.slack === 'required';
    case 'softlock':
      return sought.softlocks;
    case 'mineral-never-collectable':
      return sought.minerals;
    case 'run-does-not-complete':
      return cuts.runs === null;
    case 'verdict-hangs-on-accuracy':
      return cuts.runs === null && cuts.accuracies === null;
    case 'unused-asteroid':
      return completesItself(findings) && cuts.runs === null && cuts.nearness === null;
    // a search only reports it where it was needed, and other limits of work find other levels
    case 'found-run':
    case 'work-limit':
      return false;
    default:
      return true;
  }
}

/**
 * The problems of what a level allows although it is not there.
 * @param codes the codes of the problems that are there
 */
export function unusedAllows(findings: Findings, codes: ReadonlySet<string>): CheckProblem[] {
  return Object.keys(findings.allow).flatMap((code) =>
    codes.has(code) || !isSought(code, findings)
      ? []
      : [
          {
            code: 'unused-allow',
            severity: 'warning',
            message: `the level allows ${code}, but has no problem of this kind`,
            hint: `remove ${code} from "allow"`,
            pointer: `/allow/${code}`,
          },
        ],
  );
}
