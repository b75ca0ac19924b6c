import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

// Ties the results of runs to the version of the package, as docs/versioning.md promises: results.json has the identity of the
// engine for each line of versions within which results stay the same.

const PROJECT = dirname(import.meta.dirname);

/**
 * The line of versions within which results stay the same: the major version, and before 1.0 the minor version.
 * @param {string} version such as 0.1.2
 * @returns {string} such as 0.1
 */
export function lineOf(version) {
  const [major, minor] = version.split('.');
  return major === '0' ? `0.${minor}` : major;
}

/**
 * @param {{ readonly version: string, readonly identity: string, readonly results: Readonly<Record<string, string>>, readonly changelog: string }} found
 *   version of the package, identity of its engine, identities by line, text of CHANGELOG.md
 * @returns {string[]} what contradicts the promise, and what to do
 */
export function versionProblems({ version, identity, results, changelog }) {
  const problems = [];
  const line = lineOf(version);
  const next = line.startsWith('0.') ? `0.${Number(line.slice(2)) + 1}` : String(Number(line) + 1);
  if (results[line] === undefined) {
    problems.push(`.ci/results.json has no line ${line} for version ${version}: add "${line}": "${identity}"`);
  } else if (results[line] !== identity) {
    problems.push(
      `results of runs have changed: versions ${line}.x have the engine ${results[line]}, this one is ${identity}. Expected the same results, or version ${next}.0 in package.json with "${next}": "${identity}" in .ci/results.json (before ${line}.0 is released: the new identity there)`,
    );
  }
  const identities = Object.values(results);
  for (const [i, [name, id]] of Object.entries(results).entries()) {
    if (!/^[0-9a-f]{16}$/.test(id)) problems.push(`.ci/results.json: ${name}: expected 16 hexadecimal digits, found ${id}`);
    if (identities.indexOf(id) !== i)
      problems.push(`.ci/results.json: ${name} has the identity of another line: results did not change`);
    if (!changelog.includes(`\n## [${name}.`)) problems.push(`CHANGELOG.md has no heading for ${name}, in which results changed`);
  }
  return problems;
}

/** The same for this package, as it is built. */
export async function problemsHere() {
  const read = (path) => readFileSync(join(PROJECT, path), 'utf8');
  const { ENGINE_ID: identity } = await import('../dist/game/index.js');
  const { version } = JSON.parse(read('package.json'));
  return versionProblems({ version, identity, results: JSON.parse(read('.ci/results.json')), changelog: read('CHANGELOG.md') });
}
