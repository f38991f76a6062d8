"""Reports of Coapt's outputs: one HTML file that opens in any browser."""
