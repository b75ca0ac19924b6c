import { useStore } from 'zustand';
import { heatCaption, heatColour } from '../../../picture/index.ts';
import { ShadeLegend } from '../../canvas/index.ts';
import { usePageTheme, useSession } from '../../core/context/index.ts';
import { useSolverSession } from './use-solver-session.ts';

/**
 * The legend of the heat map: what the squares count, and which shade means how many visits. Empty while the heat map is
 * hidden.
 */
export function HeatLegend() {
  const { overlay } = useSolverSession();
  const explored = useStore(overlay, ({ heat }) => heat);
  const isShown = useSession(({ layers }) => layers.heatMap);
  const theme = usePageTheme();
  if (explored === null || !isShown) return null;
  return (
    <ShadeLegend
      label="Search heat map"
      caption={heatCaption(explored)}
      map={explored}
      colour={heatColour(theme)}
      opacityOf={(shade) => shade}
      corner="left"
    />
  );
}
