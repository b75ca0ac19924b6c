import { Section } from '../../core/panel/index.ts';
import { DifficultyReport } from './DifficultyReport.tsx';
import { FixReport } from './FixReport.tsx';
import { LostReport } from './LostReport.tsx';
import { RobustnessReport } from './RobustnessReport.tsx';
import { SearchReport } from './SearchReport.tsx';
import './solver.css';
import { SearchSettingsForm } from './SearchSettingsForm.tsx';

/** The solver panel: search, fixes, lost states, robustness and difficulty. */
export function Solver() {
  return (
    <div className="panel__body solver">
      <Section title="Find runs">
        <SearchSettingsForm />
        <SearchReport />
      </Section>
      <FixReport />
      <LostReport />
      <RobustnessReport />
      <DifficultyReport />
    </div>
  );
}
