import { quote } from '../basics/format-value.ts';
import { toWords } from '../basics/names.ts';
import { type Finding, MAX_FINDINGS } from '../basics/problem.ts';
import { type Contradiction, contradictionsIn } from './contradictions.ts';

/** What is wrong with a level beyond its shape, in words. Accepts any JSON value. */
export function checkMeaning(level: unknown): Finding[] {
  const findings: Finding[] = [];
  for (const contradiction of contradictionsIn(level)) {
    if (findings.length === MAX_FINDINGS) break;
    findings.push(toFinding(contradiction, level));
  }
  return findings;
}

function toFinding(found: Contradiction, level: unknown): Finding {
  const { path } = found;
  if (found.what === 'reversed') {
    const { press, release } = found;
    const problem = release === press ? 'never holds the gun' : 'is reversed';
    const hint = release === press ? 'Remove it, or release later.' : `Write [${release}, ${press}].`;
    const message = `${toWords(path, level)}: [${press}, ${release}] ${problem}: the release must come after the press`;
    return { code: 'reversed-hold', message, hint, path, part: 'value' };
  }
  const { name, first } = found;
  const isRun = path[0] === 'runs';
  const message = `${toWords(path)}: the ${isRun ? 'name' : 'id'} ${quote(name)} already belongs to ${toWords(first)}`;
  const hint = isRun ? 'Rename one of the two.' : 'Remove it here: gq fmt writes a new one.';
  return { code: isRun ? 'duplicate-run-name' : 'duplicate-id', message, hint, path, part: 'value' };
}
