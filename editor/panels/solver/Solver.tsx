import { Section } from '../parts/index.ts';
import { DifficultyReport } from './DifficultyReport.tsx';
import { RobustnessReport } from './RobustnessReport.tsx';
import { SearchReport } from './SearchReport.tsx';
import './solver.css';
import { SearchSettingsForm } from './SearchSettingsForm.tsx';

/** Looks for runs, says what the shown one forgives and how hard the level is. */
export function Solver() {
  return (
    <div className="panel__body solver">
      <Section title="Look for runs">
        <SearchSettingsForm />
        <SearchReport />
      </Section>
      <RobustnessReport />
      <DifficultyReport />
    </div>
  );
}
