import { Search } from 'lucide-react';
import { useId } from 'react';
import { type Card, effectsOf, type Filter, isFiltered } from './pack-model.ts';

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
