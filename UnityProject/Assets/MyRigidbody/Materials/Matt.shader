// A body in its colour, matt, and always lit from the same side: so it looks alike in the built-in pipeline, in URP and in HDRP,
// whatever lights a scene has and however a pipeline counts their intensity.
Shader "MyRigidbody/Matt"
{
    Properties
    {
        _Color ("Colour", Color) = (1, 1, 1, 1)
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        CGINCLUDE
        #include "UnityCG.cginc"

        // the way to the light, world axes, of length 1
        static const float3 ToLight = float3(0.3687, 0.7660, -0.5265);

        // what is left of the colour on the far side, and on the side of the light; as seen on a screen
        static const float Darkest = 0.38;
        static const float Lightest = 1.12;

        float4 _Color;

        struct Corner
        {
            float4 position : POSITION;
            float3 normal : NORMAL;
        };

        struct Surface
        {
            float4 position : SV_POSITION;
            float3 normal : TEXCOORD0;
        };

        // the same in every pass: what has been drawn into the depth buffer is found there again to the bit
        Surface Place(Corner corner)
        {
            Surface surface;
            surface.position = UnityObjectToClipPos(corner.position.xyz);
            surface.normal = UnityObjectToWorldNormal(corner.normal);
            return surface;
        }

        // half Lambert: sides that are turned away from the light differ, too
        float4 Shade(Surface surface) : SV_Target
        {
            float facing = 0.5 + 0.5 * dot(normalize(surface.normal), ToLight);
            float shade = lerp(Darkest, Lightest, facing * facing);
            #ifndef UNITY_COLORSPACE_GAMMA
            shade = pow(shade, 2.2);
            #endif
            return float4(_Color.rgb * shade, 1);
        }

        float4 ShowDepth(Surface surface) : SV_Target
        {
            return surface.position.z;
        }

        float4 ShowNormal(Surface surface) : SV_Target
        {
            return float4(normalize(surface.normal), 0);
        }
        ENDCG

        // without a LightMode: the built-in pipeline draws it as it is, URP and HDRP as SRPDefaultUnlit
        Pass
        {
            Name "Colour"
            CGPROGRAM
            #pragma vertex Place
            #pragma fragment Shade
            ENDCG
        }

        // URP, where it draws depth first
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R
            CGPROGRAM
            #pragma vertex Place
            #pragma fragment ShowDepth
            ENDCG
        }

        // URP, for the shadows in corners (SSAO)
        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormals" }
            CGPROGRAM
            #pragma vertex Place
            #pragma fragment ShowNormal
            ENDCG
        }
    }

    Fallback Off
}
