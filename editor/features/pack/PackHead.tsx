import { CircleAlert, FilePlus2, Gauge, Redo2, Search, Square, TriangleAlert, Undo2, X } from 'lucide-react';
import { useId } from 'react';
import { useStore } from 'zustand';
import type { Terms } from '../../../engine/index.ts';
import type { Problem } from '../../../schema/index.ts';
import { useEditor } from '../../core/context/index.ts';
import type { FolderPack } from '../../core/files/index.ts';
import { editPack, listHistoryOf } from '../../core/levels/index.ts';
import { Button } from '../../core/ui/index.ts';
import { NameField } from './ChapterHead.tsx';
import { gradesOf } from './grades.ts';
import { type Card, effectsOf, type Filter, isFiltered, type PackModel } from './pack-model.ts';

interface PackHeadProps {
  readonly model: PackModel;
  readonly pack: FolderPack;
  readonly terms: Terms;
  readonly canEdit: boolean;
  readonly onClose: () => void;
}

/** The name of the pack, and what can be done with all of it. */
export function PackHead({ model, pack, terms, canEdit, onClose }: PackHeadProps) {
  const editor = useEditor();
  const history = listHistoryOf(editor);
  const { undoLabel, redoLabel, undoesList, redoesList } = useStore(history.store);
  return (
    <header className="pack__head">
      <h2 className="unseen" id="pack-title">
        Pack
      </h2>
      {model.name !== null && canEdit ? (
        <NameField
          key={model.name}
          label="Name of the pack"
          name={model.name}
          className="pack__title"
          onDone={(name) => void editPack(editor, 'Rename the pack', (now) => ({ ...now, name }))}
        />
      ) : (
        <p className="pack__title">{model.name ?? 'All levels'}</p>
      )}
      <span className="pack__space" />
      <Button
        hint={undoesList ? `Undo: ${undoLabel}` : 'Undo: nothing of the list of levels'}
        shortcut="Ctrl Z"
        icon={<Undo2 size={15} />}
        disabled={!undoesList}
        onClick={history.undo}
      />
      <Button
        hint={redoesList ? `Redo: ${redoLabel}` : 'Redo: nothing of the list of levels'}
        shortcut="Ctrl Shift Z"
        icon={<Redo2 size={15} />}
        disabled={!redoesList}
        onClick={history.redo}
      />
      <Measure model={model} terms={terms} />
      {pack.kind === 'none' && (
        <Button
          hint="Write this order into a file pack.json, which then gives the order whatever the files are called"
          look="outlined"
          icon={<FilePlus2 size={15} />}
          onClick={() => void editPack(editor, 'Make pack.json', (made) => made)}
        >
          Make pack.json
        </Button>
      )}
      <Button hint="Close" shortcut="Esc" icon={<X size={16} />} onClick={onClose} />
    </header>
  );
}

/** Measures the grades that are missing, and can be stopped. */
function Measure({ model, terms }: Pick<PackHeadProps, 'model' | 'terms'>) {
  const editor = useEditor();
  const grades = gradesOf(editor);
  const running = useStore(grades.store, (state) => state.running);
  const entries = model.cards.flatMap(({ entry }) => (entry === null ? [] : [entry]));
  const missing = model.cards.filter(({ entry, grade }) => entry?.status === 'valid' && (grade === null || grade.isOld)).length;
  if (running !== null) {
    const name = model.cards.find(({ id }) => id === running.id)?.entry?.name ?? running.id;
    return (
      <span className="pack__measure">
        <progress max={running.of} value={running.done} aria-label="Levels measured" />
        <span className="pack__note pack__running">
          {running.done + 1} of {running.of}: {name}
        </span>
        <Button hint="Stop measuring; what is measured stays" look="outlined" icon={<Square size={13} />} onClick={grades.stop}>
          Stop
        </Button>
      </span>
    );
  }
  return (
    <Button
      hint={
        missing === 0
          ? 'All grades are measured'
          : 'Measure how hard each level is by its own runs, one after the other. gq difficulty searches for more runs and can find a lower grade'
      }
      look="outlined"
      icon={<Gauge size={15} />}
      disabled={missing === 0}
      onClick={() => grades.measure(entries, terms)}
    >
      {missing === 0 ? 'Measured' : 'Measure'}
    </Button>
  );
}

interface PackProblemsProps {
  readonly file: string;
  readonly problems: readonly Problem[];
  /** null: there is nothing to go to. */
  readonly onGo: ((problem: Problem) => void) | null;
}

/** What `gq check` says of the order, in the same words, with a way to each place. */
export function PackProblems({ file, problems, onGo }: PackProblemsProps) {
  if (problems.length === 0) return null;
  return (
    <section className="pack__problems" aria-label="Problems of the order">
      <ul>
        {problems.map((problem) => {
          const { code, severity, message, hint, line, column } = problem;
          const Icon = severity === 'error' ? CircleAlert : TriangleAlert;
          return (
            <li key={`${code} ${line}:${column}`} className={`pack__problem pack__problem--${severity}`}>
              <Icon size={15} aria-label={severity} />
              <div>
                <p>{message}</p>
                <p className="pack__note">
                  {hint} <span className="pack__place">{line === null ? file : `${file}:${line}:${column}`}</span>{' '}
                  <code>{code}</code>
                </p>
              </div>
              {onGo !== null && (
                <Button hint="Show it" aria-label={`Go to: ${message}`} look="outlined" onClick={() => onGo(problem)}>
                  Go to
                </Button>
              )}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

interface PackFilterProps {
  readonly filter: Filter;
  readonly cards: readonly Card[];
  readonly shown: number;
  readonly verdicts: readonly string[];
  readonly onChange: (filter: Filter) => void;
}

/** Chooses which levels are shown: by words, verdict and effect. */
export function PackFilter({ filter, cards, shown, verdicts, onChange }: PackFilterProps) {
  const id = useId();
  const effects = effectsOf(cards);
  const count = isFiltered(filter) ? `${shown} of ${cards.length} levels shown` : `${cards.length} levels`;
  return (
    <search className="pack__filter" aria-label="Levels to show">
      <span className="pack__search">
        <Search size={14} aria-hidden />
        <input
          type="search"
          className="field"
          aria-label="Find in the pack"
          placeholder="Name or file"
          value={filter.text}
          spellCheck={false}
          onChange={(event) => onChange({ ...filter, text: event.target.value })}
        />
      </span>
      <label htmlFor={`${id}-verdict`} className="unseen">
        Verdict
      </label>
      <select
        id={`${id}-verdict`}
        className="field"
        value={filter.verdict}
        onChange={(event) => onChange({ ...filter, verdict: event.target.value })}
      >
        <option value="">any verdict</option>
        {verdicts.map((verdict) => (
          <option key={verdict}>{verdict}</option>
        ))}
      </select>
      <label htmlFor={`${id}-effect`} className="unseen">
        Effect
      </label>
      <select
        id={`${id}-effect`}
        className="field"
        value={filter.effect}
        onChange={(event) => onChange({ ...filter, effect: event.target.value })}
      >
        <option value="">any effect</option>
        {effects.map(([value, words]) => (
          <option key={value} value={value}>
            {words}
          </option>
        ))}
      </select>
      <span className="pack__note" role="status">
        {count}
      </span>
    </search>
  );
}
