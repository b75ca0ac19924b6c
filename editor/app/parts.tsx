import { Files, Gauge, History, ListTree, Puzzle, SlidersHorizontal, Sparkles, TriangleAlert, Waypoints } from 'lucide-react';
import type { ReactNode } from 'react';
import { PerLevel } from '../core/context/index.ts';
import { AccuracyPanel } from '../features/accuracy/index.ts';
import { AttemptsPanel } from '../features/attempts/index.ts';
import { Effects } from '../features/effects/index.ts';
import { Inspector } from '../features/inspector/index.ts';
import { LevelsPanel } from '../features/levels/index.ts';
import { Outliner } from '../features/outliner/index.ts';
import { Problems } from '../features/problems/index.ts';
import { RunsPanel } from '../features/runs/index.ts';
import { Solver } from '../features/solver/index.ts';
import type { SidePanel } from './Layout.tsx';

/** px of an icon in a tab on a phone */
const ICON = 17;

const inLevel = (panel: ReactNode) => <PerLevel>{panel}</PerLevel>;

/** Always shown at the top of the left side. */
export const LEVELS: SidePanel = { id: 'levels', title: 'Levels', icon: <Files size={ICON} />, content: <LevelsPanel /> };

/** Below it, one at a time. */
export const LEFT: readonly SidePanel[] = [
  { id: 'outline', title: 'Outline', icon: <ListTree size={ICON} />, content: inLevel(<Outliner />) },
  { id: 'runs', title: 'Runs', icon: <Waypoints size={ICON} />, content: inLevel(<RunsPanel />) },
  { id: 'attempts', title: 'Attempts', icon: <History size={ICON} />, content: inLevel(<AttemptsPanel />) },
];

/** On the right side, one at a time. */
export const RIGHT: readonly SidePanel[] = [
  { id: 'inspector', title: 'Inspector', icon: <SlidersHorizontal size={ICON} />, content: inLevel(<Inspector />) },
  { id: 'solver', title: 'Solver', icon: <Sparkles size={ICON} />, content: <Solver /> },
  { id: 'effects', title: 'Effects', icon: <Puzzle size={ICON} />, content: <Effects /> },
  { id: 'accuracy', title: 'Accuracy', icon: <Gauge size={ICON} />, content: <AccuracyPanel /> },
];

/** Always shown at the bottom of the right side. */
export const PROBLEMS: SidePanel = {
  id: 'problems',
  title: 'Problems',
  icon: <TriangleAlert size={ICON} />,
  content: inLevel(<Problems />),
};
