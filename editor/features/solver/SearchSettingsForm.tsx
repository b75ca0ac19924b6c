import { Play, Square } from 'lucide-react';
import { useStore } from 'zustand';
import { LIMITS } from '../../../schema/index.ts';
import { keyLabel } from '../../core/commands/index.ts';
import { IS_MAC, useDocument } from '../../core/context/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import { SOLVE_KEY } from './solver-commands.ts';
import { useSolverSession } from './use-solver-session.ts';

const OBJECTIVES = [
  { value: 'robust', title: 'safest', about: 'the run that still succeeds when every press is a little off' },
  { value: 'presses', title: 'simplest', about: 'the fewest presses' },
  { value: 'time', title: 'quickest', about: 'the shortest time' },
  { value: 'first', title: 'any', about: 'the first run found' },
] as const;

/** The settings of the search and the button that starts it. */
export function SearchSettingsForm() {
  const { settings: store, search } = useSolverSession();
  const settings = useStore(store);
  const isRunning = useStore(search.store, ({ phase }) => phase === 'running');
  const minerals = useDocument(({ file }) => file.minerals?.length ?? 0);
  return (
    <div className="search-settings">
      <Segments
        label="Prefer"
        value={settings.objective}
        options={OBJECTIVES}
        onChange={(objective) => store.setState({ objective })}
      />
      {minerals > 0 && (
        <Segments
          label="Minerals"
          value={settings.minerals}
          options={[
            { value: 'any', title: 'any', about: 'minerals do not matter' },
            { value: 'some', title: 'some', about: 'at least the number below' },
            { value: 'all', title: `all ${minerals}`, about: 'all of them' },
          ]}
          onChange={(wanted) => store.setState({ minerals: wanted })}
        />
      )}
      <div className="search-settings__numbers">
        {minerals > 0 && settings.minerals === 'some' && (
          <NumberField
            label="At least"
            value={Math.min(settings.some, minerals)}
            min={1}
            max={minerals}
            whole
            onChange={(some) => store.setState({ some })}
          />
        )}
        <NumberField
          label="Seconds"
          about="Time limit of the search"
          value={settings.budget}
          min={1}
          max={3600}
          whole
          onChange={(budget) => store.setState({ budget })}
        />
        <NumberField
          label="Seed"
          about="Another seed tries other runs first"
          value={settings.seed}
          min={0}
          max={LIMITS.coordinate}
          whole
          onChange={(seed) => store.setState({ seed })}
        />
      </div>
      {isRunning ? (
        <Button hint="Stop and keep the runs found" look="outlined" icon={<Square size={14} />} onClick={search.cancel}>
          Cancel
        </Button>
      ) : (
        <Button
          hint="Find runs"
          shortcut={keyLabel(SOLVE_KEY, IS_MAC)}
          look="main"
          icon={<Play size={14} />}
          onClick={search.start}
        >
          Solve
        </Button>
      )}
    </div>
  );
}
