import { CircleCheck, CircleX, TriangleAlert } from 'lucide-react';
import { memo } from 'react';
import { joinHolds } from '../../../engine/index.ts';
import type { LevelFile, Problem } from '../../../schema/index.ts';
import { type Editor, type OpenLevel, perLevel, useEditor, useLevel } from '../../core/context/index.ts';
import { keyAt, nameOf, objectsOf, ownNameOf, type Recipe, replaceHolds } from '../../core/document/index.ts';
import { plural } from '../../core/figures/index.ts';
import { laterPanel } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Feature } from '../feature.ts';
import { keysOf, useProblems } from './index.ts';
import './problems.css';

/** A fix that does not change how any run plays. */
export interface QuickFix {
  readonly title: string;
  readonly recipe: Recipe;
}

/** The run that a pointer leads to or into; null if there is none. */
export function runAt(file: LevelFile, pointer: string): string | null {
  const match = /^\/runs\/(\d+)/.exec(pointer);
  return match === null ? null : (file.runs?.[Number(match[1])]?.name ?? null);
}

/** The safe fix of a problem; null if the user has to decide. */
export function quickFixOf(file: LevelFile, { code, pointer }: Problem): QuickFix | null {
  const name = runAt(file, pointer);
  const run = file.runs?.find((other) => other.name === name);
  if (run === undefined || name === null) return null;
  // the engine sorts and joins holds anyway
  if (code === 'holds-overlap') return { title: 'Join the holds', recipe: replaceHolds(name, joinHolds(run.holds)) };
  if (code === 'holds-unsorted') {
    return {
      title: 'Sort the holds',
      recipe: replaceHolds(
        name,
        [...run.holds].sort((a, b) => a[0] - b[0] || a[1] - b[1]),
      ),
    };
  }
  return null;
}

/** What is wrong with the level, and how to mend it. */
export const problems: Feature = {
  name: 'problems',
  panel: {
    id: 'problems',
    title: 'Problems',
    icon: <TriangleAlert size={17} />,
    side: 'right',
    place: 'fixed',
    content: perLevel(Problems),
  },
};

/** What `gq check` would report about the level on the screen, errors first. */
function Problems() {
  const problems = useProblems();
  const file = useLevel().document.file();
  const keys = keysOf(problems);
  const errors = problems.filter(({ severity }) => severity === 'error').length;
  const warnings = problems.length - errors;
  const counts = [...(errors > 0 ? [plural(errors, 'error')] : []), ...(warnings > 0 ? [plural(warnings, 'warning')] : [])];
  return (
    <div className={problems.length === 0 ? 'panel__body problems problems--none' : 'panel__body problems'}>
      <p className="problems__count" role="status">
        {problems.length === 0 ? (
          <>
            <CircleCheck size={15} className="tone--good" aria-hidden /> No errors and no warnings.
          </>
        ) : (
          counts.join(', ')
        )}
      </p>
      <ul className="problems__list" aria-label="Problems">
        {problems.map((problem, i) => (
          <ProblemCard
            key={keys[i]}
            problem={problem}
            place={placeOf(file, problem.pointer)}
            fixTitle={quickFixOf(file, problem)?.title ?? null}
          />
        ))}
      </ul>
    </div>
  );
}

const ICONS = { error: CircleX, warning: TriangleAlert } as const;

interface ProblemCardProps {
  readonly problem: Problem;
  /** The place of the problem, in words. */
  readonly place: string;
  /** The title of the quick fix; null if there is none. */
  readonly fixTitle: string | null;
}

const Explanation = laterPanel(() => import('./explanations.tsx').then((there) => there.Explanation));

/** Memoized: rendering dozens of cards again would take milliseconds. */
const ProblemCard = memo(function ProblemCard({ problem, place, fixTitle }: ProblemCardProps) {
  const editor = useEditor();
  const level = useLevel();
  const { code, severity, message, hint, pointer } = problem;
  const Icon = ICONS[severity];
  const applyFix = () => {
    const fix = quickFixOf(level.document.file(), problem);
    if (fix !== null) level.document.change(fix.title, fix.recipe);
  };
  return (
    <li className={`problem problem--${severity}`}>
      <p className="problem__head">
        <Icon size={15} aria-hidden />
        <span className="problem__severity">{severity}</span>
        <span className="problem__message">{message}</span>
      </p>
      <p className="part__note">{hint}</p>
      <div className="part__row">
        {pointer !== '' && (
          <Button hint="Select it and bring it into view" look="outlined" onClick={() => goToProblem(editor, level, problem)}>
            Go to {place}
          </Button>
        )}
        {fixTitle !== null && (
          <Button hint="Fix it now; no run changes" look="outlined" onClick={applyFix}>
            {fixTitle}
          </Button>
        )}
        {['file-unreadable', 'file-deleted', 'merge-conflict'].includes(code) && (
          <Button
            hint="Compare both versions and choose"
            look="outlined"
            onClick={() => editor.session.setState({ overlay: 'conflict' })}
          >
            Review
          </Button>
        )}
        {code === 'no-run' && (
          <Button hint="Let the solver find a run" look="outlined" onClick={() => editor.commands.run('solve.start')}>
            Solve
          </Button>
        )}
        <details className="problem__why">
          <summary>
            <code>{code}</code>
          </summary>
          <Explanation code={code} />
        </details>
      </div>
    </li>
  );
});

/** The name of the place that a pointer leads to, as other panels call it. */
function placeOf(file: LevelFile, pointer: string): string {
  const key = keyAt(file, pointer);
  const found = key === null ? undefined : objectsOf(file).get(key);
  if (found !== undefined) {
    const [name, own] = [nameOf(found), ownNameOf(found)];
    return own === name ? name.toLowerCase() : `“${own}”`;
  }
  const run = runAt(file, pointer);
  return run === null ? 'the level' : `run “${run}”`;
}

/** Shows the place of a problem: selects the object and brings it into view, or shows the run with the hold selected. */
function goToProblem({ session, commands }: Editor, { document, selection }: OpenLevel, { pointer }: Problem): void {
  const file = document.file();
  const key = keyAt(file, pointer);
  if (key !== null) {
    selection.select([key]);
    commands.run('view.fit-selection');
    return;
  }
  const run = runAt(file, pointer);
  if (run === null) {
    selection.clear();
    commands.run('view.fit');
    return;
  }
  session.setState({ run });
  const hold = /\/holds\/(\d+)/.exec(pointer)?.[1];
  const ticks = hold === undefined ? undefined : file.runs?.find(({ name }) => name === run)?.holds[Number(hold)];
  if (ticks === undefined) return;
  selection.selectHolds(run, [Number(hold)]);
  session.setState({ tick: ticks[0], isPlayingBack: false });
}
