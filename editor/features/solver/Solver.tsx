import type { ComponentType } from 'react';
import { Section } from '../../core/panel/index.ts';
import { DifficultyReport } from './DifficultyReport.tsx';
import { FixReport } from './FixReport.tsx';
import { RobustnessReport } from './RobustnessReport.tsx';
import { SearchReport } from './SearchSection.tsx';
import './solver.css';
import { SearchSettingsForm } from './SearchSettingsForm.tsx';

/** The solver panel: search, fixes, robustness and difficulty. @param sections what other features examine */
export function Solver({ sections }: { readonly sections: readonly ComponentType[] }) {
  return (
    <div className="panel__body solver">
      <Section title="Find runs">
        <SearchSettingsForm />
        <SearchReport />
      </Section>
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
