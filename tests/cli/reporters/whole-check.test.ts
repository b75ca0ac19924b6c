import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { validateXML } from 'xmllint-wasm';
import { checkGithub } from '../../../cli/reporters/github.ts';
import { checkJunit } from '../../../cli/reporters/junit.ts';
import { checkMarkdown } from '../../../cli/reporters/markdown.ts';
import { checkPretty } from '../../../cli/reporters/pretty.ts';
import { checkSarif } from '../../../cli/reporters/sarif.ts';
import { CONTEXT, checkedLevel, resultsOf, shownProblem } from './context.ts';

const excess = '1 warning: at most 0 allowed (--max-warnings)';
const warned = resultsOf([checkedLevel({ problems: [shownProblem({ severity: 'warning' })] })]);

describe('what makes a check fail although no level does', () => {
  for (const [name, report] of Object.entries({ checkPretty, checkGithub, checkJunit, checkMarkdown, checkSarif })) {
    it(`too many warnings are said by ${name}, and only then`, () => {
      expect(report({ ...warned, excess }, CONTEXT)).toContain(excess);
      expect(report(warned, CONTEXT)).not.toContain('allowed');
    });
  }

  it('is no success in Markdown', () => {
    const good = /✅|Every level is good/;
    expect(checkMarkdown(warned, CONTEXT)).toMatch(good);
    expect(checkMarkdown({ ...warned, excess }, CONTEXT)).not.toMatch(good);
    expect(checkMarkdown({ ...warned, unchecked: ['b.level.json'], interrupted: true }, CONTEXT)).not.toMatch(good);
    expect(checkMarkdown({ ...warned, interrupted: true }, CONTEXT)).not.toMatch(good);
  });

  it('is an error of no file on GitHub', () => {
    expect(checkGithub({ ...warned, excess }, CONTEXT)).toMatch(/^::error title=too many warnings::1 warning: /);
  });

  it('keeps JUnit valid', async () => {
    const contents = readFileSync(new URL('./fixtures/junit-10.xsd', import.meta.url), 'utf8');
    const xml = [{ fileName: 'report.xml', contents: checkJunit({ ...warned, excess }, { ...CONTEXT, isJenkins: true }) }];
    expect(await validateXML({ xml, schema: [{ fileName: 'junit.xsd', contents }] })).toMatchObject({ valid: true });
  });
});
