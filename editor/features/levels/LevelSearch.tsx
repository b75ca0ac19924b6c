import { Search } from 'lucide-react';
import { focusHome } from '../../core/ui/index.ts';

interface LevelSearchProps {
  /** The number of levels. */
  readonly count: number;
  readonly text: string;
  readonly onChange: (text: string) => void;
  /** Opens the first match. @returns whether there is one */
  readonly onOpenFirst: () => boolean;
}

/** Finds levels by name. */
export function LevelSearch({ count, text, onChange, onOpenFirst }: LevelSearchProps) {
  return (
    <label className="levels__search">
      <Search size={13} aria-hidden />
      <input
        type="search"
        className="field"
        placeholder={count === 1 ? 'Find in 1 level' : `Find in ${count} levels`}
        aria-label="Find a level"
        value={text}
        onChange={(event) => onChange(event.target.value)}
        onKeyDown={(event) => {
          if (event.key === 'Escape' && text !== '') onChange('');
          else if (event.key === 'Escape') focusHome();
          else if (event.key !== 'Enter' || !onOpenFirst()) return;
          event.preventDefault();
        }}
      />
    </label>
  );
}
