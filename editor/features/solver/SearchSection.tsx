import { Check, CircleCheck, CircleHelp, CircleX, Info, Play, Plus, Replace, Square, TriangleAlert, X } from 'lucide-react';
import type { ComponentType } from 'react';
import { useStore } from 'zustand';
import { LIMITS } from '../../../schema/index.ts';
import { mineralsNeeded } from '../../../solver/index.ts';
import { keyLabel } from '../../core/commands/index.ts';
import { IS_MAC, useDocument, useEditor, useProof, useSession } from '../../core/context/index.ts';
import { about, percent, plural, seconds } from '../../core/figures/index.ts';
import { Progress, Section, Segments } from '../../core/panel/index.ts';
import { showLayer } from '../../core/session/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import { useRunEnds } from '../runs/index.ts';
import { DifficultyReport } from './DifficultyReport.tsx';
import { FixReport } from './FixReport.tsx';
import { useSolverSession } from './index.ts';
import { RobustnessReport } from './RobustnessReport.tsx';
import type { Found, SearchState } from './search-session.ts';
import { type OwnRuns, summaryOf } from './search-summary.ts';
import { goalOf, RUNS_WANTED, SOLVE_KEY } from './search-task.ts';

/** The solver panel: search, fixes, robustness and difficulty. @param sections what other features examine */
export function Solver({ sections }: { readonly sections: readonly ComponentType[] }) {
  return (
    <div className="panel__body solver">
      <SearchSection />
      <FixReport />
      {sections.map((Part, key) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the list never changes
        <Part key={key} />
      ))}
      <RobustnessReport />
      <DifficultyReport />
    </div>
  );
}

/** Searches for runs: what is asked, and what was found. */
function SearchSection() {
  return (
    <Section title="Find runs">
      <SearchSettingsForm />
      <SearchReport />
    </Section>
  );
}

const OBJECTIVES = [
  { value: 'robust', title: 'safest', about: 'the run that still succeeds when every press is a little off' },
  { value: 'presses', title: 'simplest', about: 'the fewest presses' },
  { value: 'time', title: 'quickest', about: 'the shortest time' },
  { value: 'first', title: 'any', about: 'the first run found' },
] as const;

/** The settings of the search and the button that starts it. */
function SearchSettingsForm() {
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

const ICONS = { good: CircleCheck, warn: CircleHelp, bad: CircleX, plain: Info } as const;
const NO_RUNS = [] as const;

/** The state of the search and the runs it has found. */
function SearchReport() {
  const { session } = useEditor();
  const { search } = useSolverSession();
  const state = useStore(search.store);
  const heatMap = useSession(({ layers }) => layers.heatMap);
  const minerals = useDocument(({ file }) => file.minerals?.length ?? 0);
  const { phase, solving, ms, settings, found, mineralProofs } = state;
  const { tone, text, note } = summaryOf(state, useOwnRuns(state, minerals), minerals, RUNS_WANTED);
  if (phase === 'idle' || settings === null) return null;
  const Icon = ICONS[tone];
  return (
    <div className="report">
      <Progress label="Time spent" isRunning={phase === 'running'} share={Math.min(1, ms / (1000 * settings.budget))} />
      <p className={tone === 'plain' ? 'standing' : `standing tone--${tone}`} role={tone === 'bad' ? 'alert' : 'status'}>
        <Icon size={15} aria-hidden /> {text}
      </p>
      {found.length > 0 && (
        <ol className="report__found" aria-label="Runs found">
          {found.map((one, i) => (
            <FoundCard key={one.id} found={one} place={i + 1} minerals={minerals} />
          ))}
        </ol>
      )}
      {note !== null && <p className="part__note">{note}</p>}
      {mineralProofs.map(({ index, proof }) => (
        <p key={index} className="standing tone--warn">
          <TriangleAlert size={15} aria-hidden /> Mineral {index + 1} can never be collected: {proof.reason}
        </p>
      ))}
      {solving !== null && (
        <p className="part__note numbers">
          {about(solving.effort.runs)} simulations, {about(solving.effort.ticks)} ticks in {(ms / 1000).toFixed(1)} s, seed{' '}
          {settings.seed}
          {phase === 'cancelled' && ', stopped'}
        </p>
      )}
      <div className="part__row">
        {solving !== null && (
          <label className="report__heat">
            <input
              type="checkbox"
              checked={heatMap}
              onChange={({ target: { checked } }) => showLayer(session, 'heatMap', checked)}
            />
            Show the search heat map
          </label>
        )}
        {phase !== 'running' && (
          <Button hint="Discard the search results" icon={<X size={14} />} onClick={search.clear}>
            Discard
          </Button>
        )}
      </div>
    </div>
  );
}

/** Which of the level's own runs meet the goal of the search. */
function useOwnRuns({ settings }: SearchState, minerals: number): OwnRuns {
  const runs = useDocument(({ file }) => file.runs ?? NO_RUNS);
  const endOf = useRunEnds(runs);
  const needed = settings === null ? 0 : mineralsNeeded(goalOf(settings, minerals), minerals);
  const completing = runs.filter(({ name }) => endOf(name)?.outcome === 'completed');
  return {
    meets: completing.find(({ name }) => (endOf(name)?.minerals ?? 0) >= needed)?.name ?? null,
    completes: completing[0]?.name ?? null,
  };
}

function FoundCard({ found, place, minerals }: { readonly found: Found; readonly place: number; readonly minerals: number }) {
  const { search } = useSolverSession();
  const shown = useProof(({ run }) => run.name);
  const isShown = useProof(({ run }) => run.holds.join() === found.id);
  const { candidate, p40, certified, works, id } = found;
  return (
    <li
      className={works ? 'found' : 'found found--fails'}
      onPointerEnter={() => search.hover(id)}
      onPointerLeave={() => search.hover(null)}
      onFocus={() => search.hover(id)}
      onBlur={() => search.hover(null)}
    >
      <span className="found__place numbers">{place}</span>
      <div className="found__what numbers">
        <b>{works ? seconds(candidate.time) : 'fails in this level'}</b>
        <span>{plural(candidate.holds.length, 'press', 'presses')}</span>
        {minerals > 0 && (
          <span>
            minerals {candidate.minerals.length}/{minerals}
          </span>
        )}
        {p40 !== null && (
          <span title="Success with timing noise of 40 ms on every press and release">
            {percent(p40)} at 40 ms
            {certified && (
              <Check size={12} className="found__certified" aria-label=", certified: all shifts by up to 2 ticks succeed" />
            )}
          </span>
        )}
      </div>
      {isShown ? (
        <span className="found__shown tone--good">
          <Check size={13} aria-hidden /> shown
        </span>
      ) : (
        <span className="found__does">
          <Button
            hint={works ? `Add run ${place} to the level` : `Add run ${place} to the level, although it now fails there`}
            icon={<Plus size={15} />}
            look="outlined"
            onClick={() => search.use(candidate.holds)}
          >
            Add
          </Button>
          {shown !== null && works && (
            <Button
              hint={`Replace the run “${shown}” with run ${place}`}
              icon={<Replace size={15} />}
              onClick={() => search.use(candidate.holds, shown)}
            />
          )}
        </span>
      )}
    </li>
  );
}
