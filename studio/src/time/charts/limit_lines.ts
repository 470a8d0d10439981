// Lines across a chart, for comparison with its values.

export interface Limit {
  value: number;
  label: string;
  colour: string;
}

export const bothWays = (value: number, label: string, colour: string): Limit[] => [
  { value, label, colour },
  { value: -value, label, colour },
];
